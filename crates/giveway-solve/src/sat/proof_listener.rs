//! How varisat is counted and stopped.
//!
//! varisat 0.2 has neither a conflict count nor an interrupt. It writes its
//! proof as it goes, though, and gives up as soon as the writer fails: so the
//! listener reads the learnt clauses off the proof, and fails when the budget is
//! spent. Not every clause that is derived was learnt from a conflict: where a
//! literal holds for good, clauses are rewritten without it, and the proof tells
//! these apart only by what follows, which is the deletion of the old one.

use std::io::{self, Cursor, Write};
use std::rc::Rc;

use varisat_internal_proof::{ProofStep, binary_format::Parser};

use super::placeholders::Freed;
use crate::budget::{Budget, Stop};

/// The writer that varisat's proof goes to; the bytes are read and thrown away.
pub(crate) struct ProofListener<'h> {
    budget: Rc<Budget<'h>>,
    parser: Parser,
    /// The head of a step whose tail has not been written yet.
    rest: Vec<u8>,
    /// How long the rest has to be before it is read again: a long step comes
    /// in many pieces.
    wait: usize,
    /// The last step derived a clause, which counts as learnt if no deletion
    /// comes next.
    derived: bool,
    freed: Freed,
}

impl<'h> ProofListener<'h> {
    pub(crate) fn new(budget: Rc<Budget<'h>>, freed: Freed) -> Self {
        Self {
            budget,
            freed,
            parser: Parser::default(),
            rest: Vec::new(),
            wait: 0,
            derived: false,
        }
    }
}

fn stopped(stop: Stop) -> io::Error {
    io::Error::other(stop.sentence())
}

impl Write for ProofListener<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // After an error the same bytes may come again; they are of no use then.
        self.budget.check().map_err(stopped)?;
        self.rest.extend_from_slice(bytes);
        if self.rest.len() >= self.wait {
            self.read();
        }
        self.budget.report_size();
        self.budget.check().map_err(stopped)?;
        Ok(bytes.len())
    }

    /// varisat does so at the end of a call.
    fn flush(&mut self) -> io::Result<()> {
        self.read();
        let learnt = std::mem::take(&mut self.derived);
        self.budget.count_conflicts(u64::from(learnt));
        Ok(())
    }
}

impl ProofListener<'_> {
    /// Reads the steps that are whole.
    fn read(&mut self) {
        let (mut conflicts, mut derived) = (0, 0);
        let mut cursor = Cursor::new(self.rest.as_slice());
        let mut whole = 0;
        while let Ok(step) = self.parser.parse_step(&mut cursor) {
            whole = cursor.position() as usize;
            self.freed.read(&step);
            let rewritten = matches!(step, ProofStep::DeleteClause { .. });
            conflicts += u64::from(self.derived && !rewritten);
            self.derived = matches!(step, ProofStep::AtClause { .. });
            derived += u64::from(self.derived);
        }
        self.rest.drain(..whole);
        self.wait = 2 * self.rest.len();
        self.budget.count_conflicts(conflicts);
        self.budget.count_derived(derived);
    }
}
