//! Completions in a stack frame.

use val3_ide::{Completion, CompletionKind, FilePosition, completions_in};
use val3_machine::controller::Controller;
use val3_vm::FragmentContext;

use super::evaluation::EvaluationError;
use super::scratch::Scratch;
use super::{FrameEvaluator, PRINT};

/// A completion of code that is evaluated in a stack frame.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FrameCompletion {
    /// Displayed name.
    pub label: String,
    /// Type or signature; may be empty.
    pub detail: String,
    /// Kind.
    pub kind: CompletionKind,
    /// Inserted text.
    pub insert: String,
    /// Replaced byte range of the code.
    pub range: std::ops::Range<usize>,
}

impl FrameEvaluator {
    /// Completions after the first `at` bytes of the code, first for a statement, then for an expression.
    ///
    /// # Errors
    /// If the stack frame does not exist.
    pub fn completions(
        &mut self,
        controller: &Controller,
        context: FragmentContext,
        text: &str,
        at: usize,
    ) -> Result<Vec<FrameCompletion>, EvaluationError> {
        let target = self.targets.of_context(&controller.vm, context)?;
        let mut all: Vec<FrameCompletion> = Vec::new();
        for before in ["", PRINT] {
            let scratch = Scratch::new(&mut self.targets, &target, before, text);
            let Ok(offset) = u32::try_from(scratch.position(at)) else { continue };
            let position = FilePosition { file: scratch.file(), offset: offset.into() };
            for found in completions_in(scratch.db(), target.project, position) {
                let in_text = |at: val3_syntax::TextSize| scratch.offset(at.into()).saturating_sub(before.len());
                let range = in_text(found.range.start())..in_text(found.range.end());
                if all.iter().all(|known| known.label != found.label) {
                    all.push(completion(found, range));
                }
            }
        }
        Ok(all)
    }
}

fn completion(found: Completion, range: std::ops::Range<usize>) -> FrameCompletion {
    let Completion { label, detail, kind, plain, .. } = found;
    FrameCompletion { label, detail, kind, insert: plain, range }
}
