//! `giveway convert`: instances and plans in another format.

mod read;
mod targets;

use giveway_formats::{Format, write};

use crate::{
    args::{Common, Convert},
    exit::Exit,
    failure::Failure,
    output::{
        files::{self, NewFile},
        stream,
    },
};
use read::{Content, Inputs, Item};
use targets::{place, spare};

pub(crate) fn run(args: &Convert, common: &Common) -> Result<Exit, Failure> {
    let inputs = read::inputs(args, common)?;
    let mut texts = Vec::new();
    for item in &inputs.items {
        texts.extend(written(args.to, item, &inputs, common)?);
    }
    match (&args.output, texts.as_slice()) {
        (Some(folder), _) => {
            let texts = place(folder, texts)?;
            files::make_folder(folder)?;
            spare(&inputs.paths, &texts)?;
            files::write_all(&texts)?;
        }
        (None, [single]) => stream::file(single.text.as_bytes())?,
        (None, _) => {
            return Err(Failure::Usage(format!(
                "found {} files to write, expected a folder for them with --output DIR",
                texts.len()
            )));
        }
    }
    Ok(Exit::Answered)
}

/// What becomes of one of the inputs. A plan in a format of plans is written with its
/// instance, which then is nothing to be written by itself.
fn written(
    to: Format,
    item: &Item,
    inputs: &Inputs,
    common: &Common,
) -> Result<Vec<NewFile>, Failure> {
    let by_itself = matches!(to, Format::Giveway | Format::MovingAi);
    let (instance, plan) = match &item.content {
        Content::Instance(instance) if by_itself || !inputs.have_plan() => (Some(instance), None),
        Content::Instance(_) => return Ok(Vec::new()),
        Content::Plan(plan) if by_itself => (None, Some(plan)),
        Content::Plan(plan) => (inputs.instance(), Some(plan)),
    };
    let mut written =
        write(to, &item.stem, instance, plan).map_err(|fault| Failure::input(&item.name, fault))?;
    written.losses.extend(item.lost.clone());
    if !written.losses.is_empty() && !common.quiet {
        stream::note(&format!(
            "{}: warning: {} files cannot hold {}",
            item.name,
            label(to),
            written.losses.join(", ")
        ));
    }
    let files = written.files.into_iter();
    let files = files.map(|(name, text)| NewFile {
        path: name.into(),
        text,
    });
    Ok(files.collect())
}

/// A format in a sentence.
const fn label(format: Format) -> &'static str {
    match format {
        Format::MovingAi => "MovingAI",
        other => other.name(),
    }
}
