//! A table: a head and lines of words.

/// A table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sheet {
    head: Vec<&'static str>,
    lines: Vec<Vec<String>>,
}

impl Sheet {
    pub(super) fn new(head: &[&'static str]) -> Self {
        Self {
            head: head.to_vec(),
            lines: Vec::new(),
        }
    }

    pub(super) fn push(&mut self, line: Vec<String>) {
        self.lines.push(line);
    }

    /// Inserts a column before another one, with a cell a line.
    pub(super) fn insert(
        &mut self,
        index: usize,
        head: &'static str,
        cells: impl Iterator<Item = String>,
    ) {
        self.head.insert(index, head);
        for (line, cell) in self.lines.iter_mut().zip(cells) {
            line.insert(index, cell);
        }
    }

    /// As comma-separated values (RFC 4180, with `\n` at the end of lines).
    pub fn csv(&self) -> String {
        let head = self
            .head
            .iter()
            .map(|&cell| quoted(cell))
            .collect::<Vec<_>>();
        let lines = self.lines.iter();
        let lines = lines.map(|line| line.iter().map(|cell| quoted(cell)).collect());
        let all = std::iter::once(head).chain(lines);
        all.map(|line: Vec<String>| line.join(",") + "\n").collect()
    }

    /// As a table of Markdown; numbers stand on the right.
    pub fn markdown(&self) -> String {
        let is_number = |index: usize| {
            let mut cells = self.lines.iter().filter_map(|line| line.get(index));
            cells.all(|cell| cell.is_empty() || cell.parse::<f64>().is_ok())
        };
        let rule = (0..self.head.len()).map(|index| if is_number(index) { "---:" } else { "---" });
        let head = self.head.iter().map(|&cell| cell.to_owned()).collect();
        let rule = rule.map(str::to_owned).collect();
        let lines = self
            .lines
            .iter()
            .map(|line| line.iter().map(|cell| cell.replace('|', "\\|")).collect());
        let all = [head, rule].into_iter().chain(lines);
        let lines = all.map(|line: Vec<String>| ["| ", &line.join(" | "), " |\n"].concat());
        lines.collect()
    }
}

fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}
