//! Recommended next step after a run that did not end well.

use val3_lang::instruction::Family;
use val3_lang::instructions;
use val3_machine::controller::{Activity, Controller, RunStatus, TaskPosition};

use super::document::ErrorEntry;
use crate::run::encounters::Encounter;
use crate::run::end::End;
use crate::run::missing::code;

/// Returns the recommendation as one sentence; `None` if there is nothing to correct.
pub(super) fn next_step(
    end: End,
    controller: &Controller,
    error: Option<&ErrorEntry>,
    contacts: &[Encounter],
) -> Option<String> {
    if let Some(error) = error {
        return Some(correct(error));
    }
    if let Some(contact) = contacts.first() {
        return Some(contact.help());
    }
    let positions = controller.task_positions();
    let waiting = positions.iter().filter(|position| !position.activity.ends_by_itself());
    let waiting = waiting.min_by_key(|position| rank(&position.activity));
    match (end, waiting) {
        (End::Controller(RunStatus::Stuck | RunStatus::Limit), Some(position)) => Some(provide(position, controller)),
        (End::Controller(RunStatus::Limit), None) => {
            Some("no task waits for anything outside: raise --until, or add --until-ok if the program is cyclic".into())
        }
        _ => None,
    }
}

fn correct(error: &ErrorEntry) -> String {
    let place = error.at.place();
    match error.code {
        Some(code) => format!("correct the line {place}; `val3 explain {code}` explains the error"),
        None => format!("correct the line {place}: {}", error.help),
    }
}

/// Rank of a wait, of which the lowest is named: for the arm, a condition or another task, the operator, anything else.
fn rank(activity: &Activity) -> u8 {
    match activity {
        Activity::AwaitsArm(..) | Activity::AwaitsArmCondition(_) => 0,
        Activity::AwaitsCondition | Activity::AwaitsTask(_) => 1,
        Activity::Suspended => 2,
        _ => 3,
    }
}

/// Describes what the task waits for, and how a script can provide it.
fn provide(position: &TaskPosition, controller: &Controller) -> String {
    let TaskPosition { name, activity, program, line, file } = position;
    let code = code(file, *line).unwrap_or_default();
    let shown = if code.is_empty() { String::new() } else { format!(" (`{code}`)") };
    let wait = format!("task `{name}` {activity} at {program}:{line}{shown}");
    match remedy(activity, &code, controller) {
        Some(remedy) => format!("{wait}: {remedy}"),
        None => wait,
    }
}

fn remedy(activity: &Activity, code: &str, controller: &Controller) -> Option<String> {
    match activity {
        // The activity's text already contains the remedy.
        Activity::AwaitsArm(..) | Activity::AwaitsArmCondition(_) => None,
        Activity::Suspended => Some("resume it from another task with taskResume".to_owned()),
        Activity::AwaitsCondition | Activity::AwaitsTask(_) => set(code, controller),
        Activity::Awaits(instruction) => match instructions::find(instruction).map(|found| found.family) {
            Some(Family::Screen) => {
                Some("type keys with --keys, or in the script: [[at]] t = 1, keys = \"1{Return}\"".into())
            }
            Some(Family::Io) => {
                Some("provide bytes in the script: [[at]] t = 1, receive = { \"LINE\" = \"TEXT\" }".into())
            }
            None if instruction == "=" => {
                Some("provide bytes in the script: [[at]] t = 1, receive = { \"LINE\" = \"TEXT\" }".into())
            }
            _ => set(code, controller),
        },
        Activity::Running | Activity::AwaitsMedium | Activity::Failed(_) => None,
    }
}

/// Recommends the script entry that sets the first signal or variable in the code.
fn set(code: &str, controller: &Controller) -> Option<String> {
    let is_part_of_name = |character: char| character.is_ascii_alphanumeric() || "_:".contains(character);
    let mut names = code.split(|character| !is_part_of_name(character)).filter(|name| !name.is_empty());
    names.find_map(|name| match controller.linked_signal(name) {
        Some(link) if !link.is_empty() => {
            Some(format!("set `{name}` in the script (--script): [[at]] t = 1, io = {{ '{link}' = true }}"))
        }
        _ => {
            let value = controller.shown_value(name)?;
            Some(format!(
                "another task has to change `{name}` (now {value}), or the script: [[at]] t = 1, set = {{ {name} = … }}"
            ))
        }
    })
}
