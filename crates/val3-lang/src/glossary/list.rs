//! List of pages: file name in the folder of the kind, words that find the page, and manual section.

use super::{EntryKind, GlossaryPage};

macro_rules! entries {
    ($($kind:ident $folder:literal { $($stem:literal [$($name:literal),+] $section:literal;)+ })+) => {
        /// All pages, by kind.
        pub static ENTRIES: &[GlossaryPage] = &[$($(
            GlossaryPage {
                kind: EntryKind::$kind,
                names: &[$($name),+],
                stem: $stem,
                section: $section,
                page: include_str!(concat!($folder, "/", $stem, ".md")),
            }
        ),+),+];
    };
}

entries! {
    Type "types" {
        "bool" ["bool"] "3.1";
        "num" ["num"] "3.2, 3.3";
        "string" ["string"] "3.4";
        "dio" ["dio"] "3.5";
        "aio" ["aio"] "3.6";
        "sio" ["sio"] "3.7";
        "screen" ["screen"] "4.2";
        "trsf" ["trsf"] "9.3";
        "frame" ["frame"] "9.4";
        "tool" ["tool"] "9.5";
        "point" ["point", "pointRx", "pointRs", "pointVrb"] "9.6";
        "joint" ["joint", "jointRx", "jointRs", "jointVrb"] "9.2";
        "config" ["config", "configRx", "configRs", "configVrb"] "9.7";
        "mdesc" ["mdesc"] "10.5";
    }
    Field "fields" {
        "x" ["x", "y", "z"] "9.3.1";
        "rx" ["rx", "ry", "rz"] "9.3.2";
        "trsf" ["trsf"] "9.4.1, 9.5.1, 9.6.1";
        "fatherId" ["fatherId"] "9.4.1, 9.5.1, 9.6.1";
        "link" ["link"] "3.5.1, 3.6.1, 3.7.1";
        "gripper" ["gripper", "ioLink"] "9.5.1";
        "otime" ["otime", "ioOpen", "open"] "9.5.1";
        "ctime" ["ctime", "ioClose", "close"] "9.5.1";
        "config" ["config"] "9.6.1";
        "shoulder" ["shoulder", "lefty", "righty", "ssame", "sfree"] "9.7.4, 9.7.5";
        "elbow" ["elbow", "epositive", "enegative", "esame", "efree"] "9.7.4";
        "wrist" ["wrist", "wpositive", "wnegative", "wsame", "wfree"] "9.7.4";
        "j1" ["j1", "j2", "j3", "j4", "j5", "j6"] "9.2.1";
        "accel" ["accel"] "10.3, 10.5.1";
        "vel" ["vel"] "10.3, 10.5.1";
        "decel" ["decel"] "10.3, 10.5.1";
        "tvel" ["tvel", "tmax"] "10.3, 10.5.1";
        "rvel" ["rvel", "rmax"] "10.3, 10.5.1";
        "blend" ["blend", "off"] "10.1.2, 10.5.1";
        "leave" ["leave"] "10.1.2, 10.5.1";
        "reach" ["reach"] "10.1.2, 10.5.1";
    }
    Operator "operators" {
        "equal" ["==", "!="] "3.1.2, 3.2.2, 3.4.2, 9.2.2";
        "less" ["<", "<=", ">", ">="] "3.2.2, 9.2.2";
        "add" ["+"] "3.2.2, 3.4.2, 9.2.2";
        "subtract" ["-"] "3.2.2, 9.2.2";
        "multiply" ["*"] "3.2.2, 9.3.3";
        "divide" ["/"] "3.2.2";
        "remainder" ["%"] "3.2.2";
        "not" ["!"] "3.1.2, 9.3.3";
    }
    Word "words" {
        "alter" ["alter mode"] "11.2";
        "application" ["application"] "2.1";
        "array" ["array", "index"] "2.3.4, 2.5.5";
        "cartesian" ["Cartesian", "cartesian", "joint move"] "9.1, 10.1.1";
        "cell" ["cell", "controller", "backup"] "6.6";
        "collection" ["collection", "key"] "2.3.4, 2.5.6";
        "compliant-move" ["compliant move", "force control"] "11.1";
        "configuration" ["configuration", "posture"] "9.7, 10.1.4";
        "connection-move" ["connection move"] "10.1.3";
        "cycle" ["cycle"] "5.4, 5.7";
        "disk" ["Disk://", "Disk", "USB0", "path"] "6.6";
        "father" ["father", "reference frame", "reference tool"] "9.4.1, 9.5.1, 9.6.1";
        "files" ["files", ".pjx", ".dtx", ".pgx", "pjx", "dtx", "pgx"] "2.1, 2.2";
        "flange" ["flange"] "9.5.1";
        "length-unit" ["length unit", "unit", "millimeterUnit"] "2.1.4";
        "library" ["library", "library identifier", "interface", "alias"] "6";
        "monitor-speed" ["monitor speed"] "10.3, 10.4";
        "move" ["move"] "10.1, 10.2";
        "move-id" ["move id"] "10.4";
        "mutex" ["mutex"] "5.9";
        "parameter" ["parameter", "by reference", "by value", "&"] "2.6";
        "pendant" ["pendant", "MCP", "user page"] "4.1";
        "power" ["power"] "8.1";
        "precedence" ["precedence"] "3.1.2, 3.2.2";
        "program" ["program", "local variable"] "2.2";
        "public" ["public", "private"] "2.5.2, 6.2";
        "run-time-error" ["run-time error", "runtime error"] "5.2, 12.1";
        "signal" ["signal", "device", "io"] "3.5, 3.6";
        "singularity" ["singularity"] "10.1.4";
        "synchronous-task" ["synchronous task"] "5.5, 5.6";
        "task" ["task"] "5.1, 5.4";
        "tool-centre-point" ["tool centre point", "tool center point", "TCP"] "9.1, 9.5.1";
        "user-type" ["user type"] "7";
        "variable" ["variable", "data", "container"] "2.3, 2.5";
        "version" ["version", "dialect", "s5", "s6", "s7", "s8", "CS8", "CS9"] "8.1";
        "working-mode" ["working mode"] "8.1";
        "world" ["world"] "9.4.1";
    }
}
