//! Shipped arms by name.

use std::error::Error;
use std::fmt;

use crate::Arm;
use crate::files::FILES;

/// The six-axis arm of a cell that names none.
pub const DEFAULT_SIX_AXIS: &str = "TX2-90";

/// The SCARA arm of a cell that names none.
pub const DEFAULT_SCARA: &str = "TS2-60";

/// No shipped arm has this name. A caller can propose similar ones of [`Arm::names`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownArm {
    /// The name.
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
    /// The names of all shipped arms.
    pub fn names() -> impl Iterator<Item = &'static str> {
        FILES.iter().map(|(name, _)| *name)
    }

    /// The shipped arm with this name, in the spelling of catalogues (`TX2-60L`) or controllers (`tx2_60l-S1`).
    pub fn by_name(name: &str) -> Result<Self, UnknownArm> {
        let wanted = normalized(name);
        let file = FILES.iter().find(|(name, _)| normalized(name) == wanted);
        file.and_then(|(_, text)| Self::from_toml(text).ok()).ok_or_else(|| UnknownArm { name: name.to_owned() })
    }

    /// The shipped arm of a cell: entries `arm` and, for SCARA arms, `lengthAxis3` of `arm.cfx` (`ts60-S1`, `L400`).
    pub fn by_settings(arm: &str, length_axis3: Option<&str>) -> Result<Self, UnknownArm> {
        let variant = length_axis3.map(|length| format!("{}-{length}", base(arm)));
        let variant = variant.and_then(|name| Self::by_name(&name).ok());
        variant.map_or_else(|| Self::by_name(arm), Ok)
    }
}

/// Letters and digits of a name in lower case, without what does not change the kinematics.
fn normalized(name: &str) -> String {
    let name = base(name.trim()).to_ascii_lowercase().replace("touch", "");
    name.chars().filter(char::is_ascii_alphanumeric).collect()
}

/// The name without the revision of the arm: `ts60` of `ts60-S1`.
fn base(name: &str) -> &str {
    let revision = |end: &str| {
        let digits = end.strip_prefix(['s', 'S']);
        digits.is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()))
    };
    name.rsplit_once(['-', '_']).filter(|(_, end)| revision(end)).map_or(name, |(start, _)| start)
}
