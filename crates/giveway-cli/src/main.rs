//! The command `giveway`: reads files and the command line, asks the solver's
//! service, and writes what it answers.
#![cfg_attr(
    test,
    allow(
        clippy::needless_raw_string_hashes,
        reason = "UPDATE_EXPECT=1 writes expected texts so"
    )
)]

mod args;
mod clock;
mod commands;
mod exit;
mod failure;
mod input;
mod interrupt;
mod output;
mod progress;

use std::process::ExitCode;

use clap::Parser;

use crate::{args::Args, clock::Clock, exit::Exit};

fn main() -> ExitCode {
    let clock = Clock::start();
    let exit = match Args::try_parse() {
        Ok(args) => commands::run(&args, clock).unwrap_or_else(|failure| failure.tell()),
        Err(message) => {
            // Help and version are messages, too. Where the reader went away
            // there is nobody to tell.
            let _ = message.print();
            if message.use_stderr() {
                Exit::Usage
            } else {
                Exit::Answered
            }
        }
    };
    if interrupt::happened() {
        Exit::Interrupted.into()
    } else {
        exit.into()
    }
}
