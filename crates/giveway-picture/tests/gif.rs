//! GIFs, read again by the library's decoder.
#![cfg(feature = "gif")]
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use std::ops::ControlFlow;

use giveway_model::format::native;
use giveway_model::{Instance, Plan};
use giveway_picture::gif::{Encoder, Failure, Reel, Shot, gif};
use giveway_picture::{Ink, Inks, Look, Theme, robot};

/// An agent that goes along a row of cells, and then stays as long as it takes.
fn row(steps: usize) -> (Instance, Plan, Look) {
    let goal = steps.min(1000);
    let cells = ".".repeat(goal + 1);
    let scene = format!(
        r#"{{ "giveway": 1, "map": ["{cells}"], "agents": [
            {{ "name": "A", "start": [0, 0], "goal": [{goal}, 0] }}] }}"#
    );
    let path: Vec<String> = (0..=steps)
        .map(|step| format!("[{},0]", step.min(goal)))
        .collect();
    let plan = format!(
        r#"{{ "giveway": 1, "paths": {{ "A": [{}] }} }}"#,
        path.join(",")
    );
    let instance = native::read_instance(&scene).unwrap();
    let look = Look {
        cell: 10,
        ..Look::fitting(instance.grid(), 1000)
    };
    (instance, native::read_plan(&plan).unwrap(), look)
}

/// Draws what a shot is about in a very simple way: a square where the agent is.
fn drawn(shot: &Shot, at: f64) -> Vec<u8> {
    let inks = Inks::of(Theme::Light);
    let (fill, _) = robot(Theme::Light, giveway_picture::Colours::default(), 0);
    let (width, height) = shot.size;
    let left = 12.0 + (at * 10.0).round();
    let mut pixels = Vec::new();
    for y in 0..height {
        for x in 0..width {
            let is_agent = (left..left + 10.0).contains(&f64::from(x)) && (12..22).contains(&y);
            let Ink(parts) = if is_agent { fill } else { inks.floor };
            pixels.extend(parts);
            pixels.push(255);
        }
    }
    pixels
}

/// How long a picture is seen, and its pixels.
type Seen = (u16, Vec<[u8; 3]>);

/// The pictures of a GIF as they are seen, and their size.
fn seen(bytes: &[u8]) -> (Vec<Seen>, (u16, u16)) {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut file = options.read_info(bytes).unwrap();
    let (width, height) = (file.width(), file.height());
    let mut canvas = vec![[0; 3]; usize::from(width) * usize::from(height)];
    let mut seen = Vec::new();
    while let Some(frame) = file.read_next_frame().unwrap() {
        for (index, pixel) in frame.buffer.chunks_exact(4).enumerate() {
            let x = usize::from(frame.left) + index % usize::from(frame.width);
            let y = usize::from(frame.top) + index / usize::from(frame.width);
            if pixel[3] > 0 {
                canvas[y * usize::from(width) + x] = [pixel[0], pixel[1], pixel[2]];
            }
        }
        seen.push((frame.delay, canvas.clone()));
    }
    (seen, (width, height))
}

#[test]
fn frames_come_back_as_they_were_drawn() {
    let (instance, plan, look) = row(3);
    let reel = Reel::new(&instance, &plan, &look).unwrap();
    assert_eq!((reel.count(), reel.size()), (25, (64, 58)));
    let mut index = 0;
    let mut told = Vec::new();
    let draw = |shot: &Shot| {
        assert_eq!(shot.ground.is_some(), index == 0);
        index += 1;
        Ok::<_, ()>(drawn(shot, reel.time(index - 1)))
    };
    let tell = |done, all| {
        told.push((done, all));
        ControlFlow::Continue(())
    };
    let bytes = gif(&instance, &plan, &look, draw, tell).unwrap();
    assert_eq!(
        (told.first(), told.last()),
        (Some(&(0, 25)), Some(&(24, 25)))
    );
    let (seen, size) = seen(&bytes);
    assert_eq!((seen.len(), size), (25, (64, 58)));
    for (index, (_, picture)) in seen.iter().enumerate() {
        let expect = drawn(&reel.shot(index), reel.time(index));
        let expect: Vec<[u8; 3]> = expect.chunks(4).map(|p| [p[0], p[1], p[2]]).collect();
        assert!(*picture == expect, "frame {index}");
    }
    let delays: Vec<u16> = seen.iter().map(|(delay, _)| *delay).collect();
    assert_eq!((delays[0], delays[1], delays[24]), (60, 6, 180));
    // The same plan gives the same bytes, and each frame holds little.
    let mut index = 0;
    let again = |shot: &Shot| {
        index += 1;
        Ok::<_, ()>(drawn(shot, reel.time(index - 1)))
    };
    let again = gif(&instance, &plan, &look, again, |_, _| {
        ControlFlow::Continue(())
    })
    .unwrap();
    assert!(bytes == again);
    assert!(bytes.len() < 4000, "{}", bytes.len());
}

#[test]
fn a_frame_in_which_nothing_changes_prolongs_the_one_before() {
    let (instance, plan, look) = row(2);
    let draw = |shot: &Shot| Ok::<_, ()>(drawn(shot, 0.0));
    let bytes = gif(&instance, &plan, &look, draw, |_, _| {
        ControlFlow::Continue(())
    })
    .unwrap();
    let (seen, _) = seen(&bytes);
    let delays: Vec<u16> = seen.iter().map(|(delay, _)| *delay).collect();
    assert_eq!(delays, [60 + 15 * 6 + 180]);
}

#[test]
fn it_can_be_stopped_and_fails_as_its_drawing_does() {
    let (instance, plan, look) = row(2);
    let mut frames = 0;
    let draw = |shot: &Shot| {
        frames += 1;
        Ok::<_, ()>(drawn(shot, 0.0))
    };
    let stop = |done, _| {
        if done == 5 {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    };
    assert_eq!(
        gif(&instance, &plan, &look, draw, stop),
        Err(Failure::Stopped)
    );
    assert_eq!(frames, 5);
    let broken = |_: &Shot| Err("no paper");
    let result = gif(&instance, &plan, &look, broken, |_, _| {
        ControlFlow::Continue(())
    });
    assert_eq!(result, Err(Failure::Draw("no paper")));
}

#[test]
fn frames_of_a_wrong_size_or_number_are_refused() {
    let (instance, plan, look) = row(1);
    let reel = Reel::new(&instance, &plan, &look).unwrap();
    let mut encoder = Encoder::new(&reel);
    let refused = encoder.push(&[0; 7]).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "found a frame of 7 bytes, expected 44 x 58 pixels"
    );
    let frame = drawn(&reel.shot(0), 0.0);
    for _ in 0..reel.count() {
        encoder.push(&frame).unwrap();
    }
    assert!(encoder.push(&frame).is_err());
    assert!(encoder.finish().is_ok());
    assert!(Encoder::new(&reel).finish().is_err());
}

#[test]
fn long_plans_have_fewer_frames_a_step_and_larger_ones_are_refused() {
    let count = |steps: usize, cell: u32| {
        let (instance, plan, look) = row(steps);
        let look = Look { cell, ..look };
        Reel::new(&instance, &plan, &look)
            .map(|reel| reel.count())
            .map_err(|it| it.to_string())
    };
    assert_eq!(count(100, 10), Ok(801));
    // 657 000 pixels a frame.
    assert_eq!(count(100, 60), Ok(401));
    assert_eq!(count(700, 2), Ok(2801));
    assert_eq!(count(1000, 2), Ok(2001));
    let sentence = count(3500, 2).unwrap_err();
    assert!(
        sentence.starts_with("The GIF is too large: 3501 frames of 2026 x 50 pixels."),
        "{sentence}"
    );
    assert!(count(100, 256).is_err());
}
