//! Default run of a folder that contains several applications.

use camino::{Utf8Component, Utf8Path, Utf8PathBuf};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The run of `val3 run` in a folder of which no application is named: the table `[run.default]`. Arguments of the command
/// take precedence.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct DefaultRun {
    /// The application, a folder or a `.pjx`, relative to the folder of this file.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>")]
    pub application: Option<Utf8PathBuf>,
    /// The script of the run, relative to the folder of this file.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>")]
    pub script: Option<Utf8PathBuf>,
    /// The seconds of the controller's clock after which the run ends.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64")]
    pub until: Option<f64>,
    /// Whether reaching `until` is the normal end of the run, with exit code 0.
    pub until_ok: bool,
    /// Whether the run shows where the time went, by program line.
    pub times: bool,
    /// The picture of the motion that the run writes, below the folder of this file: `"path.svg"`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>")]
    pub plot: Option<Utf8PathBuf>,
    /// The page for browsers that plays the run again, below the folder of this file: `"run.html"`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>")]
    pub export: Option<Utf8PathBuf>,
}

impl DefaultRun {
    /// Returns the files that the run writes, each with its key and its file extension.
    fn written(&self) -> impl Iterator<Item = (&'static str, &Utf8Path, &'static str)> {
        let plot = self.plot.as_deref().map(|path| ("plot", path, "svg"));
        let export = self.export.as_deref().map(|path| ("export", path, "html"));
        plot.into_iter().chain(export)
    }

    /// Returns the key of the first setting that a run cannot use, and the reason.
    pub(crate) fn fault(&self) -> Option<(&'static str, String)> {
        let is_unreachable = self.until.is_some_and(|until| !(0.0..1e9).contains(&until));
        if is_unreachable {
            return Some(("until", "is no number of seconds from 0 to 1e9".to_owned()));
        }
        self.written().find_map(|(key, path, extension)| Some((key, unwritable(path, extension)?)))
    }
}

/// Returns the reason why a run cannot write a file at `path`. The check of the extension prevents a cell from
/// replacing other kinds of files.
fn unwritable(path: &Utf8Path, extension: &str) -> Option<String> {
    if !path.components().all(is_visible) {
        return Some(format!(
            "writes `{path}`: name a file below the folder of this file, without `..` and hidden folders"
        ));
    }
    if path.extension() != Some(extension) {
        return Some(format!("writes `{path}`: name a file that ends with `.{extension}`"));
    }
    None
}

/// Whether a part of a path is a name that does not hide the file, and does not leave the folder on Windows.
fn is_visible(part: Utf8Component<'_>) -> bool {
    match part {
        Utf8Component::Normal(name) => !name.starts_with('.') && !name.contains([':', '\\']),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::ConfigFile;

    fn fault(text: &str) -> String {
        let text = format!("[run.default]\n{text}\n");
        ConfigFile::parse("/cell/val3.toml".into(), &text).map_or_else(|error| error.message, |_| "ok".to_owned())
    }

    #[test]
    fn a_run_writes_pictures_and_pages_below_its_folder() {
        assert_eq!(fault("plot = \"out/path.svg\"\nexport = \"run.html\"\nuntil = 11\nuntil-ok = true"), "ok");
        let paths = [
            "../path.svg",
            "/tmp/path.svg",
            ".git/path.svg",
            "out/./../path.svg",
            "C:path.svg",
            "a\\\\..\\\\b.svg",
            "",
        ];
        let faults: Vec<String> = paths.iter().map(|path| fault(&format!("plot = \"{path}\""))).collect();
        expect![[r#"
            `run.default.plot` writes `../path.svg`: name a file below the folder of this file, without `..` and hidden folders
            `run.default.plot` writes `/tmp/path.svg`: name a file below the folder of this file, without `..` and hidden folders
            `run.default.plot` writes `.git/path.svg`: name a file below the folder of this file, without `..` and hidden folders
            `run.default.plot` writes `out/./../path.svg`: name a file below the folder of this file, without `..` and hidden folders
            `run.default.plot` writes `C:path.svg`: name a file below the folder of this file, without `..` and hidden folders
            `run.default.plot` writes `a\..\b.svg`: name a file below the folder of this file, without `..` and hidden folders
            `run.default.plot` writes ``: name a file that ends with `.svg`"#]].assert_eq(&faults.join("\n"));
        expect!["`run.default.plot` writes `Makefile`: name a file that ends with `.svg`"]
            .assert_eq(&fault("plot = \"Makefile\""));
        expect!["`run.default.export` writes `run.svg`: name a file that ends with `.html`"]
            .assert_eq(&fault("export = \"run.svg\""));
        expect!["`run.default.until` is no number of seconds from 0 to 1e9"].assert_eq(&fault("until = 1e10"));
    }
}
