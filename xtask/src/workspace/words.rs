//! Words for names, texts and comments.

/// Parts of data names.
pub(super) const NOUNS: &[&str] = &[
    "Pick", "Place", "Home", "Tray", "Part", "Feed", "Safe", "Count", "Speed", "Limit", "State", "Mode", "Index",
    "Cycle", "Offset", "Height", "Layer", "Row", "Column", "Grip", "Door", "Clamp", "Camera", "Scan", "Label", "Batch",
    "Order", "Line", "Belt", "Press", "Drill", "Weld", "Glue", "Test", "Good", "Next", "Last", "Box", "Bag", "Pallet",
];

/// First parts of program names.
pub(super) const VERBS: &[&str] =
    &["init", "move", "pick", "place", "check", "read", "write", "show", "wait", "set", "get", "reset", "find", "run"];

/// Texts for the screen and the log.
pub(super) const TEXTS: &[&str] = &[
    "ready",
    "part missing",
    "press any key",
    "gripper is not closed",
    "waiting for the conveyor",
    "door is open",
    "cycle finished",
    "Position hors limites",
    "Greifer öffnen",
    "Disk://log/trace.txt",
    "speed: ",
    "layer ",
    "",
    "OK",
    "unknown product",
];

/// Comments, without slashes.
pub(super) const COMMENTS: &[&str] = &[
    "leave the press before the door closes",
    "the sensor needs one cycle",
    "go back to the safe height",
    "wait for the conveyor",
    "one more layer",
    "reset the counters",
    "see the drawing of the tray",
    "---------------------------------------------",
    "operator has to confirm",
    "keep the speed low near the fixture",
    "vérifier la pince",
    "only the first part has a label",
];
