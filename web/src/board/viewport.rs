//! The size of the board on the screen, and the camera over it.

use std::cell::Cell;
use std::rc::Rc;

use giveway_model::Cell as MapCell;
use giveway_page::Point;
use giveway_page::board::{CELL, Camera, Frame};
use giveway_page::grow::Room;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::{Element, HtmlElement, ResizeObserver};
use yew::prelude::*;

/// What changes what is in sight. Pixels count from the board's upper left.
#[derive(Clone, Copy, Debug)]
pub(super) enum Look {
    /// The board got another size.
    Screen((f64, f64)),
    /// Another map is on it, or more around it.
    Board(Room),
    /// Larger or smaller around a pixel, or around the middle.
    Zoom(f64, Option<(f64, f64)>),
    /// Moved by so many pixels.
    Pan((f64, f64)),
    /// Two fingers: larger or smaller around a pixel, and moved by so many.
    Pinch(f64, (f64, f64), (f64, f64)),
    /// All of the map.
    Fit,
    /// This point of the map in the middle, in cells.
    Middle(Point),
    /// This cell too.
    Show(MapCell),
    /// This cell, which was looked for.
    Find(MapCell),
}

#[derive(Clone, PartialEq)]
struct Looked {
    camera: Camera,
    /// The one that shows all.
    whole: Camera,
    room: Room,
    screen: Option<(f64, f64)>,
}

impl Reducible for Looked {
    type Action = Look;

    fn reduce(self: Rc<Self>, look: Look) -> Rc<Self> {
        let Self {
            camera,
            room,
            screen,
            ..
        } = *self;
        let (board, before) = (room.size, room.before);
        let px = screen.unwrap_or((0.0, 0.0));
        let middle = (px.0 / 2.0, px.1 / 2.0);
        let camera = match look {
            Look::Screen(px) => {
                return Rc::new(Self {
                    screen: Some(px),
                    ..(*self).clone()
                });
            }
            Look::Board(room) if room == self.room => return self,
            Look::Board(room) => {
                return Rc::new(Self {
                    room,
                    whole: self.whole,
                    camera: self.whole,
                    screen,
                });
            }
            Look::Zoom(factor, at) => camera.zoom(factor, at.unwrap_or(middle), board, px),
            Look::Pan(by) => camera.pan(by, board, px),
            Look::Pinch(factor, at, by) => camera.zoom(factor, at, board, px).pan(by, board, px),
            Look::Fit => self.whole,
            Look::Middle(Point { x, y }) => {
                let middle = Point {
                    x: x + f64::from(before.0),
                    y: y + f64::from(before.1),
                };
                camera.centred(middle, board, px)
            }
            Look::Show(cell) => camera.show(moved(cell, before), board, px),
            Look::Find(cell) => camera.find(moved(cell, before), board, px),
        };
        Rc::new(Self {
            camera,
            whole: self.whole,
            room,
            screen,
        })
    }
}

/// A cell of the map, as one of the room around it.
fn moved(cell: MapCell, before: (u32, u32)) -> MapCell {
    MapCell::new(
        cell.x.saturating_add(before.0),
        cell.y.saturating_add(before.1),
    )
}

/// What is in sight, and how that is changed.
#[derive(Clone, PartialEq)]
pub(super) struct Viewport {
    /// The camera.
    pub(super) camera: Camera,
    /// Changes what is in sight.
    pub(super) look: Callback<Look>,
    screen: Option<(f64, f64)>,
}

impl Viewport {
    /// What is in sight of a map with room around it.
    pub(super) fn frame(&self, room: Room) -> Frame {
        room.frame(self.frame_of(&self.camera, room.size))
    }

    /// What another camera sees of such a map from here.
    pub(super) fn frame_of(&self, camera: &Camera, board: (u32, u32)) -> Frame {
        camera.frame(board, self.screen_for(board))
    }

    /// Whether cells are as large as they get.
    pub(super) fn is_nearest(&self, board: (u32, u32)) -> bool {
        self.camera.is_nearest(board, self.screen_for(board))
    }

    /// Before the board was measured: some size of the right shape.
    fn screen_for(&self, board: (u32, u32)) -> (f64, f64) {
        let guess = (f64::from(board.0) * CELL, f64::from(board.1) * CELL);
        self.screen.unwrap_or(guess)
    }
}

/// The viewport of an area that shows a map with room around it, all of it at first as by the
/// camera `whole`.
#[hook]
pub(super) fn use_viewport(area: &NodeRef, room: Room, whole: Camera) -> Viewport {
    let sight = use_reducer_eq(|| Looked {
        camera: whole,
        whole,
        room,
        screen: None,
    });
    let look = use_callback(sight.dispatcher(), |look, sight| sight.dispatch(look));
    {
        let (area, look) = (area.clone(), look.clone());
        use_effect_with((), move |()| watch_size(&area, look));
    }
    {
        let (area, look) = (area.clone(), look.clone());
        use_effect_with(room, move |&room| {
            tell_shape(&area, room.size);
            look.emit(Look::Board(room));
        });
    }
    let is_new = sight.room != room;
    Viewport {
        camera: if is_new { whole } else { sight.camera },
        look,
        screen: sight.screen,
    }
}

/// What is in sight, for what moves by hand: it changes without a rendering of those
/// who hold it.
pub(super) type Sight = Rc<Cell<Frame>>;

/// The sight of a component that shows this.
#[hook]
pub(super) fn use_sight(frame: Frame) -> Sight {
    let sight = use_memo((), |()| Cell::new(frame));
    sight.set(frame);
    sight
}

/// Tells the style sheets how many cells there are: where the board may be as
/// high as it likes, its height follows from them.
fn tell_shape(area: &NodeRef, board: (u32, u32)) {
    if let Some(area) = area.cast::<HtmlElement>() {
        let style = area.style();
        // A browser that refuses shows a board of another height.
        let _ = style.set_property("--columns", &board.0.to_string());
        let _ = style.set_property("--rows", &board.1.to_string());
    }
}

fn watch_size(area: &NodeRef, look: Callback<Look>) -> Box<dyn FnOnce()> {
    let Some(area) = area.cast::<Element>() else {
        return Box::new(|| ());
    };
    let measure = {
        let area = area.clone();
        move || {
            let rect = area.get_bounding_client_rect();
            // On paper the board gives way to another one: the view stays as it was.
            if rect.width() == 0.0 || rect.height() == 0.0 {
                return;
            }
            look.emit(Look::Screen((rect.width(), rect.height())));
        }
    };
    measure();
    let measured = Closure::<dyn Fn()>::new(measure);
    let Ok(observer) = ResizeObserver::new(measured.as_ref().unchecked_ref()) else {
        return Box::new(|| ());
    };
    observer.observe(&area);
    Box::new(move || {
        observer.disconnect();
        drop(measured);
    })
}
