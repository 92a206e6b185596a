//! Answers of tools that change files.

use camino::Utf8Path;

use crate::answer::Answer;
use crate::changes::Changes;
use crate::refusal::Refusal;
use crate::report::counted;
use crate::tool::Call;

/// Writes changes unless it is a dry run. The answer describes them: changed lines, and new findings of the projects
/// below `path`.
pub(crate) fn changed(call: &Call<'_>, changes: &Changes, path: &Utf8Path, dry_run: bool) -> Result<Answer, Refusal> {
    if changes.is_empty() {
        return Ok(Answer::new(true, "nothing changes: the files already contain this"));
    }
    let effect = changes.effect(call.roots, path)?;
    if !dry_run {
        changes.write(call.roots)?;
    }
    let mut text = if dry_run { "nothing was written; the change is:\n" } else { "written\n" }.to_owned();
    text.push_str(&changes.diff(call.roots));
    let new = counted(effect.new.len() as u64, "new finding");
    text.push_str(&format!("{new}, {} solved\n", effect.solved));
    effect.new.iter().for_each(|finding| text.push_str(&format!("{finding}\n")));
    Ok(Answer::new(!effect.has_errors, text))
}
