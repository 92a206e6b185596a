//! Trusted folders: their settings may refer to paths outside the cell.
//!
//! A cell is often cloned or received from another person. Its files may control the tools only inside the cell: the
//! repository that contains the file, otherwise the folder of the file. The user trusts folders, and the binary
//! connects this module to the user's list.

use std::sync::OnceLock;

use camino::Utf8Path;

use crate::{AddOnStandIn, ArmModel, ConfigError, ConfigFile, DefaultRun};

/// Access to the user's list of trusted folders. Links in paths are resolved.
#[derive(Debug, Clone, Copy)]
pub struct UserTrust {
    /// Returns whether the user trusts the settings in a folder.
    pub trusts: fn(&Utf8Path) -> bool,
    /// Returns whether a folder is the user's home, which contains cells but is never one.
    pub is_home: fn(&Utf8Path) -> bool,
}

static USER: OnceLock<UserTrust> = OnceLock::new();

impl UserTrust {
    /// Connects the user's list, once for the process. Without a connection, no folder is trusted.
    pub fn connect(self) {
        // Only the first connection has an effect.
        let _ = USER.set(self);
    }
}

/// Whether the user trusts the settings in `folder`, whose links are resolved.
pub fn is_trusted(folder: &Utf8Path) -> bool {
    USER.get().is_some_and(|user| (user.trusts)(folder))
}

/// Whether `folder`, whose links are resolved, is the user's home.
pub fn is_home(folder: &Utf8Path) -> bool {
    USER.get().is_some_and(|user| (user.is_home)(folder))
}

/// A path in a settings file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedPath<'f> {
    /// Key of the setting, for example `roots.USB0`.
    pub key: String,
    /// Path, relative to the folder of the file.
    pub path: &'f Utf8Path,
}

impl NamedPath<'_> {
    /// Whether the path refers to a library, whose surroundings programs can access.
    pub fn is_library(&self) -> bool {
        self.key.starts_with("test.replace.") || self.key.starts_with("run.add-ons.")
    }
}

impl ConfigFile {
    /// Returns all paths in the file that a command reads, writes or mounts.
    pub fn named_paths(&self) -> Vec<NamedPath<'_>> {
        let config = &self.config;
        let arm = match config.arm.as_ref().and_then(|arm| arm.model()) {
            Some(ArmModel::File(path)) => Some(NamedPath { key: "arm".to_owned(), path }),
            _ => None,
        };
        let mut named: Vec<NamedPath<'_>> = arm.into_iter().collect();
        let mut add = |key: String, path| named.push(NamedPath { key, path });
        config.disk.iter().for_each(|path| add("disk".to_owned(), path));
        config.roots.iter().for_each(|(root, path)| add(format!("roots.{root}"), path));
        config.add_ons.iter().for_each(|path| add("add-ons".to_owned(), path));
        config.baseline.iter().for_each(|path| add("baseline".to_owned(), path));
        config.run.cell.iter().filter(|path| *path != "none").for_each(|path| add("run.cell".to_owned(), path));
        config.run.shapes.iter().for_each(|(link, shape)| add(format!("run.shapes.{link}"), &shape.file));
        for (name, stand_in) in &config.run.add_ons {
            if let AddOnStandIn::Program(program) = stand_in {
                add(format!("run.add-ons.{name}"), program.folder());
            }
        }
        let DefaultRun { application, script, plot, export, .. } = &config.run.default;
        for (key, path) in [("application", application), ("script", script), ("plot", plot), ("export", export)] {
            path.iter().for_each(|path| add(format!("run.default.{key}"), path));
        }
        config.test.replace.iter().for_each(|(identifier, path)| add(format!("test.replace.{identifier}"), path));
        named
    }

    /// Creates the error of a setting that refers to a path outside of `cell`. `reach` is the verb phrase of the
    /// message.
    pub fn outside(&self, key: &str, reach: &str, cell: &Utf8Path) -> ConfigError {
        let help = format!(
            "files in `{cell}` count only inside it, unless you trust their author: {}",
            trust_command(self.folder())
        );
        self.fault(key, format!("`{key}` {reach}"), help)
    }
}

/// Returns the command that adds a folder to the user's list.
pub fn trust_command(folder: &Utf8Path) -> String {
    match folder.as_str() {
        "" => "val3 trust .".to_owned(),
        plain if plain.chars().all(is_plain) => format!("val3 trust {plain}"),
        other => format!("val3 trust '{}'", other.replace('\'', r"'\''")),
    }
}

/// Whether the character has no special meaning in a shell.
fn is_plain(c: char) -> bool {
    c.is_alphanumeric() || "/\\:._-+@".contains(c)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    const EVERY_PATH: &str = r#"
arm = "arms/own.toml"
disk = "usr/usrapp"
roots = { USB0 = "usb" }
add-ons = ["tables/a.cfx"]
baseline = "known.json"
[run]
shapes = { base = "base.stl" }
cell = "line.toml"
add-ons = { '$velJoint' = { program = "standIns/velJoint.pgx" }, '$isReady' = true }
[run.default]
application = "usr/usrapp/main"
script = "cell/day.toml"
plot = "path.svg"
export = "run.html"
[test]
replace = { part = "fake/part" }
"#;

    fn file(text: &str) -> ConfigFile {
        ConfigFile::parse(Utf8Path::new("/cell/val3.toml"), text).unwrap()
    }

    /// All settings with a path are included. The test fails for a new setting that is not checked.
    #[test]
    fn every_setting_with_a_path_is_named() {
        let sources = [
            include_str!("add_on_stand_in.rs"),
            include_str!("config.rs"),
            include_str!("link_shape.rs"),
            include_str!("run_settings.rs"),
            include_str!("default_run.rs"),
            include_str!("suite_settings.rs"),
        ];
        let is_path = |line: &&str| line.trim_start().starts_with("pub ") && line.contains("Utf8PathBuf");
        let fields = sources.iter().flat_map(|source| source.lines()).filter(is_path).count();
        let file = file(EVERY_PATH);
        let named = file.named_paths();
        assert_eq!(named.len(), fields + 1, "the setting `arm` is a path or a name: {named:?}");
    }

    #[test]
    fn a_refusal_names_the_setting_and_the_command() {
        let file = file("roots = { X = \"/\" }\n");
        expect![[r#"
            `roots.X` resolves to `/`, outside of the cell
             --> /cell/val3.toml:1
              |
            1 | roots = { X = "/" }
              |           ^
              help: files in `/cell` count only inside it, unless you trust their author: val3 trust /cell"#]]
        .assert_eq(&file.outside("roots.X", "resolves to `/`, outside of the cell", "/cell".into()).to_string());
    }

    #[test]
    fn commands_can_be_pasted() {
        assert_eq!(trust_command("".into()), "val3 trust .");
        assert_eq!(trust_command("/a/b-c".into()), "val3 trust /a/b-c");
        assert_eq!(trust_command("/my cell/$x'".into()), r"val3 trust '/my cell/$x'\'''");
    }

    #[test]
    fn nothing_is_trusted_without_the_users_list() {
        assert!(!is_trusted("/".into()) && !is_home("/".into()));
    }
}
