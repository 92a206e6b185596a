//! Loading of another application by a client.

use std::sync::Arc;

use camino::Utf8Path;
use val3_analysis::db::{Database, FileRange};
use val3_analysis::items::project::folder;
use val3_bytecode::Image;
use val3_check::diagnostic::Diagnostic;
use val3_lines::LineIndex;
use val3_machine::controller::PreparedProject;
use val3_machine::files::{ControllerPath, FileFault, LibraryFiles, LibraryPath};

use super::FrameEvaluator;
use super::replace::form_of;
use crate::libraries::open_stored;
use crate::pages;

/// Project that is loaded in place of the present application, or the application itself.
#[derive(Debug)]
pub struct LoadRequest<'a> {
    /// Name of the project on the media.
    pub path: &'a str,
    /// Files of the project.
    pub files: LibraryFiles,
    /// Image of the present application.
    pub present: &'a Image,
    /// Whether the project is the present application.
    pub is_present: bool,
}

impl FrameEvaluator {
    /// Compiles a project, in the form of the present application. From now on, code is evaluated in this project.
    ///
    /// # Errors
    /// The controller's compiler rejects the project; the text is the first error with its file and line.
    pub fn load_project(&mut self, request: LoadRequest<'_>) -> Result<PreparedProject, String> {
        let LoadRequest { path, files, present, is_present } = request;
        let path = ControllerPath::parse(path, &ControllerPath::root("")).and_then(|path| LibraryPath::new(&path));
        let path =
            path.map_err(|fault: FileFault| format!("the path is invalid (error {} of libLoad)", fault.code()))?;
        let main = self.targets.application(0);
        let (db, project) = (main.db(), main.project());
        let own = folder(db, project);
        let disk = project.disk(db).or(own.parent()).unwrap_or(own).to_owned();
        let inside = match Utf8Path::new(&present.path).parent().filter(|_| is_present) {
            // The application of a run may be outside of `Disk`.
            Some(folder) => folder.to_owned(),
            None => path.folder().parts().iter().fold(disk, |folder, part| folder.join(part.as_str())),
        };
        let (application, _) = open_stored(inside, &files, &[])?;
        if let Some(wrong) = application.refusals().first() {
            return Err(located(wrong, application.db()));
        }
        application.check_readable().map_err(|error| error.to_string())?;
        let image = application.compile_as(form_of(present)).map_err(|error| error.limit.to_string())?;
        let pages = pages::of(application.db(), application.project());
        self.targets.set_main(application);
        self.patched.clear();
        Ok(PreparedProject { image, path: path.path().to_string(), files: Arc::new(files), pages })
    }
}

/// Message of a finding after its file and line.
fn located(finding: &Diagnostic, db: &Database) -> String {
    let FileRange { file, range } = finding.place;
    let line = LineIndex::new(file.text(db)).line(range.start().into()) + 1;
    let name = file.path(db).file_name().unwrap_or_default();
    format!("{name}:{line}: {}", finding.message)
}
