//! A plan that moves, as a file: drawn by the page frame by frame where it is a GIF, and
//! put together by the reader.

use giveway_model::tr;
use giveway_model::{Instance, Plan, Scene};
use giveway_picture::gif::{Encoder, Reel, Shot};
use giveway_picture::{Look, moving};

use super::protocol::{Ask, Message, PictureKind, Reply, Task};
use super::work::work;

/// How far it is, is told once in so many frames.
const TELLS: usize = 5;

/// The reader at work: all but a GIF it does at once.
#[derive(Default)]
pub struct Reader {
    film: Option<Box<Film>>,
}

/// A GIF that is being made.
struct Film {
    id: u64,
    name: String,
    reel: Reel,
    encoder: Encoder,
    next: usize,
}

impl Reader {
    /// Does what it is asked, and tells what there is to tell.
    pub fn answer(&mut self, Ask { id, task }: Ask, tell: &mut dyn FnMut(Message)) {
        let reply = match task {
            Task::Picture {
                kind,
                stem,
                scene,
                plan,
                look,
            } => match begin((id, stem), scene, &plan, &look, kind) {
                Ok(Picture::Svg(name, svg)) => Some(Reply::Drawn(name, svg.into_bytes())),
                Ok(Picture::Gif(film)) => {
                    film.ask(tell);
                    self.film = Some(film);
                    None
                }
                Err(sentence) => Some(refused(sentence)),
            },
            Task::Pixels(pixels) => match self.film.take().filter(|film| film.id == id) {
                Some(film) => film.go_on(&pixels, &mut self.film, tell),
                // Of a film that is none any longer.
                None => None,
            },
            task => Some(work(task)),
        };
        if let Some(reply) = reply {
            tell(Message::Reply { id, reply });
        }
    }
}

/// A picture: whole with its name, or begun.
enum Picture {
    Svg(String, String),
    Gif(Box<Film>),
}

fn begin(
    (id, stem): (u64, String),
    scene: Scene,
    plan: &Plan,
    look: &Look,
    kind: PictureKind,
) -> Result<Picture, String> {
    let instance = Instance::new(scene).map_err(|faults| {
        let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
        faults.join("; ")
    })?;
    Ok(match kind {
        PictureKind::Svg => Picture::Svg(format!("{stem}.svg"), moving(&instance, plan, look)),
        PictureKind::Gif => {
            let reel = Reel::new(&instance, plan, look).map_err(|large| large.to_string())?;
            Picture::Gif(Box::new(Film {
                id,
                name: format!("{stem}.gif"),
                encoder: Encoder::new(&reel),
                reel,
                next: 0,
            }))
        }
    })
}

fn refused(sentence: String) -> Reply {
    Reply::Refused(
        tr!("The moving picture could not be made.").to_owned(),
        vec![sentence],
    )
}

impl Film {
    /// Asks the page for the next frame.
    fn ask(&self, tell: &mut dyn FnMut(Message)) {
        let (id, next, all) = (self.id, self.next, self.reel.count());
        if next % TELLS == 0 {
            let sentence = tr!(
                "Drawing the moving picture, frame {next} of {all} …",
                next = next + 1,
                all
            );
            tell(Message::Progress { id, sentence });
        }
        let shot: Shot = self.reel.shot(next);
        tell(Message::Draw { id, shot });
    }

    /// Takes the pixels of a frame; the reply, once it is whole.
    fn go_on(
        mut self: Box<Self>,
        pixels: &[u8],
        rest: &mut Option<Box<Self>>,
        tell: &mut dyn FnMut(Message),
    ) -> Option<Reply> {
        self.next += 1;
        let is_whole = self.next == self.reel.count();
        if !is_whole {
            // The page draws while this one is taken in.
            self.ask(tell);
        }
        if let Err(broken) = self.encoder.push(pixels) {
            return Some(refused(broken.to_string()));
        }
        if !is_whole {
            *rest = Some(self);
            return None;
        }
        Some(match self.encoder.finish() {
            Ok(bytes) => Reply::Drawn(self.name, bytes),
            Err(broken) => refused(broken.to_string()),
        })
    }
}
