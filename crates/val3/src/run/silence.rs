//! Notes on a run without output: what its tasks wait for, and why time is real.

use std::collections::{BTreeMap, BTreeSet};
use std::time::{Duration, Instant};

use val3_lang::ports::nanoseconds;
use val3_machine::controller::{Controller, TaskPosition};
use val3_machine::event::seconds;

/// Real time without output after which a run lists what its tasks wait for.
const NOTE_DELAY: Duration = Duration::from_secs(3);

/// Polling interval of the tasks in real time.
const INTERVAL: Duration = Duration::from_millis(250);

/// Location and reason of a wait that may never end: file, line, activity.
type WaitState = (String, u32, String);

/// Output and notes that the user has received.
#[derive(Debug)]
pub(super) struct Silence {
    /// Time of the last output or note.
    last_output: Instant,
    last_look: Instant,
    /// Waits by task name, with the time at which each wait was first observed.
    waits: BTreeMap<String, (WaitState, Instant)>,
    /// Waits in the last note; `None` before the first note.
    noted: Option<BTreeSet<(String, WaitState)>>,
    /// Whether the note on real time was given.
    has_noted_time: bool,
}

impl Silence {
    pub(super) fn new(now: Instant) -> Self {
        Self { last_output: now, last_look: now, waits: BTreeMap::new(), noted: None, has_noted_time: false }
    }

    /// Records that the user has received output.
    pub(super) fn see_output(&mut self, now: Instant) {
        self.last_output = now;
    }

    /// Returns the note that time is real because a line has an external peer; only once.
    pub(super) fn note_on_time(&mut self, controller: &Controller) -> Option<String> {
        if self.has_noted_time {
            return None;
        }
        let (link, task) = controller.outside_peer()?;
        self.has_noted_time = true;
        let user = task.map_or_else(|| "a task".to_owned(), |task| format!("task `{task}`"));
        Some(format!("note: {user} has a peer on `{link}`: time is real; `receive` in a script keeps it virtual"))
    }

    /// Returns the first line of a note on waiting tasks, if the run has had no output for `NOTE_DELAY` and its waits
    /// differ from the last note.
    pub(super) fn note_on_waits(&mut self, now: Instant, controller: &Controller) -> Option<String> {
        if now.duration_since(self.last_look) < INTERVAL {
            return None;
        }
        self.last_look = now;
        self.look(now, &controller.task_positions());
        if now.duration_since(self.last_output) < NOTE_DELAY {
            return None;
        }
        let lasting = self.waits.iter().filter(|(_, (_, since))| now.duration_since(*since) >= NOTE_DELAY);
        let lasting: BTreeSet<_> = lasting.map(|(task, (state, _))| (task.clone(), state.clone())).collect();
        if self.noted.as_ref().is_some_and(|noted| lasting.is_subset(noted)) {
            return None;
        }
        self.noted = Some(lasting);
        self.last_output = now;
        let time = seconds(controller.now() - controller.now() % nanoseconds(0.1));
        Some(format!("note: the run continues, after {time} s of the controller's clock"))
    }

    fn look(&mut self, now: Instant, positions: &[TaskPosition]) {
        let before = std::mem::take(&mut self.waits);
        for position in positions {
            let Some(state) = wait_state(position) else { continue };
            let since =
                before.get(&position.name).filter(|(known, _)| *known == state).map_or(now, |(_, since)| *since);
            self.waits.insert(position.name.clone(), (state, since));
        }
    }
}

/// Wait state of a task; `None` if the wait ends by itself.
fn wait_state(position: &TaskPosition) -> Option<WaitState> {
    let TaskPosition { activity, line, file, .. } = position;
    (!activity.ends_by_itself()).then(|| (file.clone(), *line, activity.to_string()))
}

#[cfg(test)]
mod tests {
    use val3_machine::controller::Activity;

    use super::*;

    fn waiting(line: u32, activity: Activity) -> Vec<TaskPosition> {
        vec![TaskPosition { name: "work".into(), activity, program: "work".into(), line, file: "work.pgx".into() }]
    }

    #[test]
    fn a_wait_lasts_while_its_place_and_reason_are_the_same() {
        let start = Instant::now();
        let mut silence = Silence::new(start);
        let since = |silence: &Silence| silence.waits.get("work").map(|(_, since)| *since - start);
        silence.look(start, &waiting(3, Activity::AwaitsCondition));
        silence.look(start + INTERVAL, &waiting(3, Activity::AwaitsCondition));
        assert_eq!(since(&silence), Some(Duration::ZERO));
        silence.look(start + NOTE_DELAY, &waiting(4, Activity::AwaitsCondition));
        assert_eq!(since(&silence), Some(NOTE_DELAY));
        silence.look(start + NOTE_DELAY, &waiting(4, Activity::Running));
        assert_eq!(since(&silence), None);
    }
}
