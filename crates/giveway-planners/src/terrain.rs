//! The map as a graph: vertices and arcs by number.

use giveway_model::{Cell, Grid, constraint::Heading};

/// A vertex: the number of a free cell, row by row.
pub type Vertex = u32;

/// One direction of an edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Arc {
    /// Its number; the two arcs of an edge are `2 e` and `2 e + 1`.
    pub id: u32,
    /// Where it leads.
    pub to: Vertex,
    /// Whether it takes two steps, in transit after the first.
    pub slow: bool,
}

impl Arc {
    /// The edge that it belongs to.
    pub const fn edge(self) -> u32 {
        self.id >> 1
    }

    /// Which of the edge's two directions it is.
    pub const fn forward(self) -> bool {
        self.id & 1 == 0
    }
}

/// The graph of a map.
pub struct Terrain {
    width: u32,
    cells: Vec<Cell>,
    vertices: Vec<Vertex>,
    /// The arcs that leave each vertex, and how many of the four places they take.
    arcs: Vec<[Arc; 4]>,
    degrees: Vec<u8>,
    /// From and to of each arc, by its number.
    ends: Vec<(Vertex, Vertex)>,
    chargers: Vec<bool>,
}

pub(crate) const NO_VERTEX: Vertex = Vertex::MAX;

impl Terrain {
    /// The graph of a grid.
    pub fn new(grid: &Grid) -> Self {
        let mut cells = Vec::new();
        let mut vertices = Vec::new();
        for (cell, ground) in grid.cells() {
            if ground.is_vertex() {
                vertices.push(cells.len() as Vertex);
                cells.push(cell);
            } else {
                vertices.push(NO_VERTEX);
            }
        }
        let mut terrain = Self {
            width: grid.width(),
            arcs: vec![[Arc::default(); 4]; cells.len()],
            degrees: vec![0; cells.len()],
            ends: Vec::new(),
            chargers: cells.iter().map(|&c| grid.is_charger(c)).collect(),
            cells,
            vertices,
        };
        for u in 0..terrain.cells.len() as Vertex {
            let from = terrain.cell(u);
            for cell in [Cell::new(from.x + 1, from.y), Cell::new(from.x, from.y + 1)] {
                if grid.is_vertex(cell) {
                    let slow = grid.is_slow_edge(from, cell);
                    terrain.join(u, cell, slow);
                }
            }
        }
        terrain
    }

    fn join(&mut self, u: Vertex, cell: Cell, slow: bool) {
        let Some(v) = self.vertex(cell) else { return };
        let id = self.ends.len() as u32;
        self.ends.extend([(u, v), (v, u)]);
        self.push(u, Arc { id, to: v, slow });
        let id = id + 1;
        self.push(v, Arc { id, to: u, slow });
    }

    fn push(&mut self, from: Vertex, arc: Arc) {
        let degree = &mut self.degrees[from as usize];
        self.arcs[from as usize][usize::from(*degree)] = arc;
        *degree += 1;
    }

    /// The number of vertices.
    pub fn size(&self) -> usize {
        self.cells.len()
    }

    /// The cell of a vertex.
    pub fn cell(&self, v: Vertex) -> Cell {
        self.cells[v as usize]
    }

    /// The vertex of a cell; `None` for obstacles and cells off the map.
    pub fn vertex(&self, cell: Cell) -> Option<Vertex> {
        if cell.x >= self.width {
            return None;
        }
        let index = cell.y as usize * self.width as usize + cell.x as usize;
        let found = self.vertices.get(index).copied();
        found.filter(|&v| v != NO_VERTEX)
    }

    /// The last cell of the map.
    pub fn last_cell(&self) -> Cell {
        let rows = self.vertices.len() / (self.width as usize).max(1);
        Cell::new(
            self.width.saturating_sub(1),
            (rows as u32).saturating_sub(1),
        )
    }

    /// The arcs that leave a vertex; none leave what is no vertex any more.
    pub fn arcs(&self, v: Vertex) -> &[Arc] {
        let degree = self.degrees.get(v as usize).copied().unwrap_or(0);
        let arcs = self
            .arcs
            .get(v as usize)
            .map(|arcs| &arcs[..usize::from(degree)]);
        arcs.unwrap_or_default()
    }

    /// The arc that an agent is half way along when it is about to enter a
    /// vertex, whatever became of the cell that it comes from.
    pub fn transit(&mut self, from: Option<Vertex>, to: Vertex) -> u32 {
        let there = from.and_then(|u| self.arcs(u).iter().find(|arc| arc.to == to));
        if let Some(arc) = there {
            return arc.id;
        }
        let id = self.ends.len() as u32;
        self.ends.extend([(NO_VERTEX, to), (to, NO_VERTEX)]);
        id
    }

    /// From and to of an arc.
    pub fn ends(&self, arc: u32) -> (Vertex, Vertex) {
        self.ends[arc as usize]
    }

    /// The direction of an arc; `None` where it begins off the map of today.
    pub fn heading(&self, arc: u32) -> Option<Heading> {
        let (from, to) = self.ends(arc);
        self.heading_between(from, to)
    }

    /// The direction from one vertex to its neighbour.
    pub fn heading_between(&self, from: Vertex, to: Vertex) -> Option<Heading> {
        let cell = |v: Vertex| self.cells.get(v as usize).copied();
        Heading::of(cell(from)?, cell(to)?)
    }

    /// Whether an agent may charge at a vertex.
    pub fn is_charger(&self, v: Vertex) -> bool {
        self.chargers[v as usize]
    }
}
