//! Shipped arms by name.

use std::error::Error;
use std::fmt;

use crate::Arm;
use crate::files::FILES;

/// Default six-axis arm of a cell, in the spelling of controllers.
pub const DEFAULT_SIX_AXIS: &str = "tx2_90-S1";

/// Default SCARA arm of a cell.
pub const DEFAULT_SCARA: &str = "ts2_60-S1";

/// Error: no shipped arm has this name. A caller can propose similar names from [`Arm::names`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownArm {
    /// Name.
    pub name: String,
}

impl fmt::Display for UnknownArm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known: Vec<_> = Arm::names().collect();
        write!(f, "no arm has the name `{}`; known arms: {}", self.name, known.join(", "))
    }
}

impl Error for UnknownArm {}

impl Arm {
    /// Returns the names of all shipped arms.
    pub fn names() -> impl Iterator<Item = &'static str> {
        FILES.iter().map(|(name, _)| *name)
    }

    /// Returns the shipped arm with this name, in the spelling of catalogues (`TX2-60L`) or controllers (`tx2_60l-S1`).
    pub fn by_name(name: &str) -> Result<Self, UnknownArm> {
        let text = Self::file(name)?;
        Self::from_toml(text).map_err(|_| UnknownArm { name: name.to_owned() })
    }

    /// Returns the shipped file of the arm with this name, spelled as for [`Arm::by_name`].
    pub fn file(name: &str) -> Result<&'static str, UnknownArm> {
        shipped(name)
            .or_else(|| {
                let (arm, length) = divided(name);
                shipped(arm).filter(|text| stroke(text) == length)
            })
            .ok_or_else(|| UnknownArm { name: name.to_owned() })
    }

    /// Returns the shipped arm of a cell from the entries `arm` and, for SCARA arms, `lengthAxis3` in `arm.cfx`
    /// (`ts60-S1`, `L400`).
    pub fn by_settings(arm: &str, length_axis3: Option<&str>) -> Result<Self, UnknownArm> {
        let arm = base(arm);
        let (model, _) = divided(&arm);
        match length_axis3.filter(|length| is_numbered(length, 'l')) {
            Some(length) if shipped(model).and_then(stroke).is_some() => Self::by_name(&format!("{model}-{length}")),
            _ => Self::by_name(&arm),
        }
    }
}

/// Returns the shipped file with this name.
fn shipped(name: &str) -> Option<&'static str> {
    let wanted = normalized(name);
    FILES.iter().find(|(name, _)| normalized(name) == wanted).map(|(_, text)| *text)
}

/// Returns the length of axis 3 of the SCARA arm in a file, in mm.
fn stroke(text: &str) -> Option<f64> {
    let arm = Arm::from_toml(text).ok()?;
    let [_, _, axis3, _] = arm.limits() else { return None };
    Some(axis3.max - axis3.min)
}

/// Returns the letters and digits of a name in lower case, without parts that do not change the kinematics.
fn normalized(name: &str) -> String {
    let name = base(name.trim()).to_ascii_lowercase().replace("touch", "");
    let name: String = name.chars().filter(char::is_ascii_alphanumeric).collect();
    // RS arms are TS arms with earlier controllers.
    name.strip_prefix("rs")
        .filter(|size| size.starts_with(|digit: char| digit.is_ascii_digit()))
        .map_or(name.clone(), |size| format!("ts{size}"))
}

/// Removes revision and diameter of axis 3: `ts60-L200` for `ts60-S1-D20-L200`.
fn base(name: &str) -> String {
    let mut parts = name.split_inclusive(['-', '_']);
    let first = parts.next().unwrap_or_default().to_owned();
    let mut kept =
        parts.filter(|part| !is_numbered(part, 's') && !is_numbered(part, 'd')).fold(first, |name, part| name + part);
    kept.truncate(kept.trim_end_matches(['-', '_']).len());
    kept
}

/// Divides a name into the arm and the length of axis 3 in mm: `ts60` and 200 for `ts60-L200`.
fn divided(name: &str) -> (&str, Option<f64>) {
    let length = name.rsplit_once(['-', '_']).filter(|(_, end)| is_numbered(end, 'l'));
    length.map_or((name, None), |(arm, length)| (arm, length.get(1..).and_then(|length| length.parse().ok())))
}

/// Whether a part of a name is this letter with digits: `S1`.
fn is_numbered(part: &str, letter: char) -> bool {
    let digits = part.trim_end_matches(['-', '_']).strip_prefix([letter, letter.to_ascii_uppercase()]);
    digits.is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()))
}
