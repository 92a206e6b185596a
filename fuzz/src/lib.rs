//! Laws that hold for any input; a violation panics. The project's tests execute them with the corpus.

mod assists;
mod cell;
mod readers;
mod trees;

pub use assists::assists;
pub use cell::{cfx, check, config};
pub use readers::{archive, arm, events, scenario, script, shape, trace};
pub use trees::parse;

/// Target: its law, and the name for its file and corpus.
pub struct FuzzTarget {
    pub name: &'static str,
    pub run: fn(&[u8]),
}

/// All targets.
pub const TARGETS: &[FuzzTarget] = &[
    FuzzTarget { name: "pgx", run: parse },
    FuzzTarget { name: "dtx", run: parse },
    FuzzTarget { name: "pjx", run: parse },
    FuzzTarget { name: "check", run: check },
    FuzzTarget { name: "cfx", run: cfx },
    FuzzTarget { name: "config", run: config },
    FuzzTarget { name: "script", run: script },
    FuzzTarget { name: "scenario", run: scenario },
    FuzzTarget { name: "events", run: events },
    FuzzTarget { name: "trace", run: trace },
    FuzzTarget { name: "arm", run: arm },
    FuzzTarget { name: "shape", run: shape },
    FuzzTarget { name: "archive", run: archive },
    FuzzTarget { name: "assists", run: assists },
];
