//! Users of a controller, which are its profiles.

use super::cfx::{Settings, TextFiles, joined};

/// A user. Passwords are not read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct User {
    /// Name, which is the name of the file.
    pub name: String,
    /// Whether this user is in effect after the start of the controller.
    pub is_default: bool,
    /// Rights that the user has, by their names in the file.
    pub rights: Vec<String>,
    /// Rights that the user does not have.
    pub denied: Vec<String>,
}

/// Reads the profiles in `configs`. A profile that cannot be read is no user, but an unread file.
pub(super) fn users(files: &mut TextFiles<'_>, configs: &str, default: Option<&str>) -> Vec<User> {
    let profiles = files.in_folder(&joined(configs, "profiles"));
    let named = profiles.into_iter().filter_map(|(path, name)| Some((path, name.rsplit_once('.')?)));
    let named: Vec<_> = named.filter(|(_, (_, extension))| extension.eq_ignore_ascii_case("cfx")).collect();
    let mut users = Vec::new();
    for (path, (name, _)) in named {
        let Some(settings) = files.text(path).map(|text| Settings::of(&text)) else { continue };
        let is_default = default.is_some_and(|default| default.eq_ignore_ascii_case(name));
        let (rights, denied) = (rights(&settings, "true"), rights(&settings, "false"));
        users.push(User { name: name.to_owned(), is_default, rights, denied });
    }
    users
}

/// Returns the names of the rights with this value in a profile.
fn rights(profile: &Settings, value: &str) -> Vec<String> {
    let settings = profile.iter().filter(|setting| setting.kind == "Bool" && setting.value == value);
    settings.map(|setting| setting.name.clone()).collect()
}
