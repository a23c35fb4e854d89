//! `giveway convert`: instances and plans in another format.

mod read;
mod targets;

use giveway_model::{
    Fault,
    format::{movingai, native},
};

use crate::{
    args::{Common, Convert, Target},
    exit::Exit,
    failure::Failure,
    output::{
        files::{self, NewFile},
        stream,
    },
};
use read::{Content, Item};
use targets::{place, spare};

pub(crate) fn run(args: &Convert, common: &Common) -> Result<Exit, Failure> {
    let inputs = read::inputs(args, common)?;
    let mut texts = Vec::new();
    for item in &inputs.items {
        match args.to {
            Target::Giveway => texts.push(to_giveway(item)),
            Target::MovingAi => texts.extend(to_movingai(item, common)?),
        }
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

/// A file by its name, not yet in a folder.
fn named(stem: &str, ending: &str, text: String) -> NewFile {
    NewFile {
        path: format!("{stem}.{ending}").into(),
        text,
    }
}

fn to_giveway(item: &Item) -> NewFile {
    let text = match &item.content {
        Content::Instance(instance) => native::write_scene(&instance.to_scene()),
        Content::Plan(plan) => native::write_plan(plan),
    };
    named(&item.stem, "json", text)
}

fn to_movingai(item: &Item, common: &Common) -> Result<[NewFile; 2], Failure> {
    let Content::Instance(instance) = &item.content else {
        let expected = "an instance, since MovingAI files hold no plans";
        return Err(Failure::input(
            &item.name,
            Fault::at("", "a plan", expected),
        ));
    };
    let map = named(&item.stem, "map", movingai::write_map(instance.grid()));
    let scenario = movingai::write_scenario(&map.path.to_string_lossy(), instance)
        .map_err(|fault| Failure::input(&item.name, fault))?;
    let losses = movingai::losses(instance);
    if !losses.is_empty() && !common.quiet {
        let losses: Vec<String> = losses.iter().map(ToString::to_string).collect();
        stream::note(&format!(
            "{}: warning: MovingAI files cannot hold {}",
            item.name,
            losses.join(", ")
        ));
    }
    Ok([map, named(&item.stem, "scen", scenario)])
}
