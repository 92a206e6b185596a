//! Selection of tests by the arguments.

use val3_suite::TestCase;

use super::previous::Previous;
use super::script_file::ScriptFile;
use crate::args::TestArgs;
use crate::user_error::UserError;

/// Selects tests by name, tags and earlier results.
pub(super) struct TestSelection<'a> {
    args: &'a TestArgs,
    /// An earlier run's report; only its failures are executed.
    failed: Option<Previous>,
    timings: Option<Previous>,
}

impl<'a> TestSelection<'a> {
    /// Creates the selection of the arguments.
    ///
    /// # Errors
    /// An earlier run's report cannot be read.
    pub(super) fn of(args: &'a TestArgs) -> Result<Self, UserError> {
        let read = |path: &Option<camino::Utf8PathBuf>| path.as_deref().map(Previous::read).transpose();
        let (failed, timings) = (read(&args.selection.failed_in)?, read(&args.selection.timings)?);
        Ok(Self { args, failed, timings })
    }

    /// Whether the test is selected.
    pub(super) fn has(&self, case: &TestCase) -> bool {
        self.has_name(case) && self.has_failed(case) && self.has_tags(case)
    }

    /// Whether tests that cannot be executed are selected. Their earlier results and tags are unknown.
    pub(super) fn has_refused(&self, case: &TestCase) -> bool {
        self.has_name(case)
    }

    fn has_name(&self, case: &TestCase) -> bool {
        let args = self.args;
        let is_named = args.exact.is_empty() || args.exact.iter().any(|exact| is_called(case, exact));
        let names = [case.name(), case.shown_name()];
        let contains = |filter: &String| names.iter().any(|name| name.contains(filter.as_str()));
        let is_filtered = args.filter.is_empty() || args.filter.iter().any(contains);
        is_named && is_filtered && !args.filter_out.iter().any(contains)
    }

    fn has_failed(&self, case: &TestCase) -> bool {
        self.failed.as_ref().is_none_or(|failed| failed.has_failed(&case.shown_name()))
    }

    /// Whether the test has the requested tags. A test whose file cannot be read is selected, so that its failure is
    /// shown.
    fn has_tags(&self, case: &TestCase) -> bool {
        let wanted = &self.args.selection;
        if wanted.tag.is_empty() && wanted.tag_out.is_empty() {
            return true;
        }
        let Ok(file) = ScriptFile::of(case) else { return true };
        let has = |word: &String| file.scenario.tags().contains(word);
        (wanted.tag.is_empty() || wanted.tag.iter().any(has)) && !wanted.tag_out.iter().any(has)
    }

    /// Tests in the part of `--shard`, in order.
    pub(super) fn part<T>(&self, tests: Vec<T>, case: impl Fn(&T) -> &TestCase) -> Vec<T> {
        let Some(shard) = self.args.shard else { return tests };
        let seconds = |test: &T| self.timings.as_ref().map(|timings| timings.seconds(&case(test).shown_name()));
        let seconds: Vec<Option<f64>> = tests.iter().map(seconds).collect();
        let is_here = shard.part(&seconds);
        tests.into_iter().zip(is_here).filter_map(|(test, is_here)| is_here.then_some(test)).collect()
    }

    /// Describes the selection, for the message that no test is selected.
    pub(super) fn described(&self) -> String {
        let TestArgs { filter, filter_out, selection, .. } = self.args;
        let failed = selection.failed_in.iter().map(|path| path.to_string()).collect::<Vec<_>>();
        [
            clause("whose name contains", filter, " or "),
            clause("without", filter_out, " and "),
            clause("with the tag", &selection.tag, " or "),
            clause("without the tag", &selection.tag_out, " and "),
            clause("that has failed in", &failed, ""),
        ]
        .concat()
    }
}

/// Clause of a sentence with quoted words; empty without words.
fn clause(before: &str, words: &[String], between: &str) -> String {
    if words.is_empty() {
        return String::new();
    }
    let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    format!(" {before} {}", quoted.join(between))
}

/// Whether the test has this name, which may be its table's common name for all rows.
pub(super) fn is_called(case: &TestCase, name: &str) -> bool {
    let of_rows = format!("{}:{}", case.shown_application(), case.program);
    [case.name(), case.program_name(), case.shown_name(), of_rows].iter().any(|known| known == name)
}
