//! Converts a listing to files in memory.

use crate::indent::dedent;
use crate::listing::{self, ListedProject, Listing};
use crate::write::{self, WrittenFile};

/// Base folder of a fixture's paths: `Disk://x/y.pjx` is `/cell/usr/usrapp/x/y.pjx`.
pub const ROOT: &str = "/cell/usr";

/// An empty program `stop`.
pub const EMPTY_STOP: &str = r#"<Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2"><Program name="stop">
<Code><![CDATA[begin
end]]></Code></Program></Programs>"#;

/// Files of a listing.
#[derive(Debug, Clone)]
pub struct Fixture {
    /// Path relative to [`ROOT`] and text, in the order of the listing. Line ends are LF; the last line has no line
    /// end.
    pub files: Vec<(String, String)>,
    /// Line number in the listing, file index, and line number in the file.
    places: Vec<(usize, usize, usize)>,
}

impl Fixture {
    /// Parses a listing; the crate's documentation describes the format.
    ///
    /// # Panics
    /// If the listing is invalid.
    #[track_caller]
    pub fn parse(listing: &str) -> Fixture {
        let mut fixture = Fixture { files: Vec::new(), places: Vec::new() };
        files(listing::read(&dedent(listing))).into_iter().for_each(|file| fixture.add(file));
        fixture
    }

    /// Adds an empty program `stop` to each project of the listing that has only `start`, because such a project is
    /// no application.
    #[must_use]
    pub fn with_stops(mut self) -> Fixture {
        const START: &str = "<Program file=\"start.pgx\" />";
        let mut stops = Vec::new();
        for (path, text) in &mut self.files {
            if let Some(project) = path.strip_suffix(".pjx")
                && text.contains(START)
                && !text.contains("\"stop.pgx\"")
            {
                *text = text.replacen(START, &format!("{START}<Program file=\"stop.pgx\" />"), 1);
                let folder = project.rsplit_once('/').map_or("", |(folder, _)| folder);
                stops.push((format!("{folder}/stop.pgx"), EMPTY_STOP.to_owned()));
            }
        }
        self.files.extend(stops);
        self
    }

    /// Returns a listing of the application `main` with lengths in inches.
    ///
    /// # Panics
    /// If the listing is invalid.
    #[must_use]
    #[track_caller]
    pub fn in_inches(listing: &str) -> String {
        let fixture = Fixture::parse(listing);
        let project =
            fixture.text("usrapp/main/main.pjx").replace("millimeterUnit=\"true\"", "millimeterUnit=\"false\"");
        format!("{}\n=== main/main.pjx\n{project}\n", listing.trim_end())
    }

    /// Text of the file at `path`, which is relative to [`ROOT`].
    ///
    /// # Panics
    /// If there is no such file.
    #[track_caller]
    pub fn text(&self, path: &str) -> &str {
        let file = self.files.iter().find(|(known, _)| known == path);
        file.map_or_else(|| panic!("the listing has no file `{path}`"), |(_, text)| text)
    }

    /// File and line number that correspond to line `line` of the listing; both numbers count from 1.
    ///
    /// Code has the listing's columns, without the common indentation. `begin` of a program follows the start
    /// tag of its element on the same line. Code that contains `]]>` is escaped, which changes its columns. Comments
    /// and blank lines between declarations are not in any file.
    pub fn place_of_line(&self, line: usize) -> Option<(&str, usize)> {
        let (_, file, line) = self.places.iter().find(|(from, _, _)| *from == line)?;
        Some((self.files.get(*file)?.0.as_str(), *line))
    }

    fn add(&mut self, file: WrittenFile) {
        let index = self.files.len();
        let lines = file.lines.iter().enumerate().filter(|(_, line)| line.number > 0);
        self.places.extend(lines.map(|(at, line)| (line.number, index, at + 1)));
        let text: Vec<&str> = file.lines.iter().map(|line| line.content.as_str()).collect();
        self.files.push((file.path, text.join("\n")));
    }
}

/// Returns the files of a listing: generated project files, unless a raw file replaces them, followed by the raw files.
fn files(listing: Listing) -> Vec<WrittenFile> {
    let given: Vec<WrittenFile> =
        listing.files.into_iter().map(|file| WrittenFile { path: file.path, lines: file.lines }).collect();
    let mut files: Vec<WrittenFile> =
        listing.projects.iter().flat_map(|project| project_files(project, &given)).collect();
    files.retain(|file| given.iter().all(|other| other.path != file.path));
    files.extend(given);
    files
}

fn project_files(project: &ListedProject, given: &[WrittenFile]) -> Vec<WrittenFile> {
    let own = project.programs.iter().map(|program| format!("{}.pgx", program.head.content.name));
    let folder = write::path(project, "");
    let given = given.iter().filter_map(|file| file.path.strip_prefix(&folder));
    let mut names: Vec<String> = own.chain(given.filter(|name| name.ends_with(".pgx")).map(str::to_owned)).collect();
    names.sort();
    names.dedup();
    let programs = project.programs.iter().map(|program| write::program(project, program));
    [write::project(project, names), write::data_file(project)].into_iter().chain(programs).collect()
}

#[cfg(test)]
mod tests {
    use super::{EMPTY_STOP, Fixture};

    const LISTING: &str = r#"
        num nCount = 3
        string sText = "a<b"
        dio dIn["door"]
        tool tGrip
        public point pPick[2]
        library part "Disk://part/part.pjx" autoload=false

        public program pick(num x_n, num& x_g[,])
          joint l_j
        begin
          // text
          if x_n<1
        end
        nCount=nCount+1

        --- part
        public num nWeight
        === /configs/arm.cfx
        <arm />
    "#;

    #[test]
    fn files_of_a_listing() {
        let fixture = Fixture::parse(LISTING);
        let paths: Vec<&str> = fixture.files.iter().map(|(path, _)| path.as_str()).collect();
        let main = ["usrapp/main/main.pjx", "usrapp/main/main.dtx", "usrapp/main/pick.pgx", "usrapp/main/start.pgx"];
        assert_eq!(paths[..4], main);
        assert_eq!(paths[4..], ["usrapp/part/part.pjx", "usrapp/part/part.dtx", "configs/arm.cfx"]);
    }

    #[test]
    fn a_program_is_written() {
        let expected = r#"<?xml version="1.0" encoding="utf-8"?>
<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
  <Program name="pick" access="public">
    <Parameters xmlns="http://www.staubli.com/robotics/VAL3/Param/1">
      <Parameter name="x_n" type="num" xsi:type="element" />
      <Parameter name="x_g" type="num" xsi:type="array" use="reference" dimensions="2" />
    </Parameters>
    <Locals>
      <Local name="l_j" type="joint" xsi:type="array" size="1" />
    </Locals>
    <Code><![CDATA[begin
  // text
  if x_n<1
end]]></Code>
  </Program>
</Programs>"#;
        assert_eq!(Fixture::parse(LISTING).text("usrapp/main/pick.pgx"), expected);
    }

    #[test]
    fn data_and_values_are_written() {
        let fixture = Fixture::parse(LISTING);
        let text = fixture.text("usrapp/main/main.dtx");
        let lines: Vec<&str> = text.lines().skip(3).map(str::trim).collect();
        let expected = r#"<Data name="nCount" access="private" xsi:type="array" type="num" size="1">
<Value key="0" value="3" />
</Data>
<Data name="sText" access="private" xsi:type="array" type="string" size="1">
<Value key="0" value="a&lt;b" />
</Data>
<Data name="dIn" access="private" xsi:type="collection" type="dio">
<Value key="door" />
</Data>
<Data name="tGrip" access="private" xsi:type="array" type="tool" size="1">
<Value key="0" fatherId="flange[0]" />
</Data>
<Data name="pPick" access="public" xsi:type="array" type="pointRx" size="2">
<Value key="0" fatherId="world[0]" />
<Value key="1" fatherId="world[0]" />
</Data>
</Datas>
</Database>"#;
        assert_eq!(lines.join("\n"), expected);
    }

    #[test]
    fn markers_have_their_positions() {
        let fixture = Fixture::parse(LISTING);
        assert_eq!(fixture.place_of_line(2), Some(("usrapp/main/main.dtx", 4)));
        assert_eq!(fixture.place_of_line(7), Some(("usrapp/main/main.pjx", 12)));
        assert_eq!(fixture.place_of_line(13), Some(("usrapp/main/pick.pgx", 13)));
        assert_eq!(fixture.place_of_line(15), Some(("usrapp/main/start.pgx", 3)));
        assert_eq!(fixture.place_of_line(20), Some(("configs/arm.cfx", 1)));
        assert_eq!(fixture.place_of_line(8), None);
    }

    #[test]
    fn lines_without_a_program_are_the_program_start() {
        let fixture = Fixture::parse("// why\nbWait=true\n");
        assert!(fixture.text("usrapp/main/start.pgx").contains("<![CDATA[begin\n// why\nbWait=true\nend]]></Code>"));
    }

    #[test]
    fn a_given_file_replaces_and_joins() {
        let fixture = Fixture::parse("num nA\n=== main/main.dtx\n<Database />\n=== main/run.pgx\n<Programs />");
        assert_eq!(fixture.text("usrapp/main/main.dtx"), "<Database />");
        assert!(fixture.text("usrapp/main/main.pjx").contains(r#"<Program file="run.pgx" />"#));
    }

    #[test]
    #[should_panic(expected = "expected a local or `begin`")]
    fn code_before_begin() {
        Fixture::parse("program p()\nnA=1\nbegin\nend");
    }

    #[test]
    #[should_panic(expected = "a local has no initial value")]
    fn a_local_with_a_value() {
        Fixture::parse("program p()\nnum l_nA = 1\nbegin\nend");
    }

    #[test]
    #[should_panic(expected = "a local collection has no keys")]
    fn a_local_with_keys() {
        Fixture::parse("program p()\nnum l_nA[\"a\"]\nbegin\nend");
    }

    #[test]
    fn an_application_gets_the_program_stop() {
        let listing = "cls()\n--- part\npublic num nA\n--- other\ncls()\nprogram stop()\nbegin\nend";
        let (before, after) = (Fixture::parse(listing), Fixture::parse(listing).with_stops());
        assert_eq!(after.files.len(), before.files.len() + 1);
        assert_eq!(after.text("usrapp/main/stop.pgx"), EMPTY_STOP);
        let entries = r#"<Program file="start.pgx" /><Program file="stop.pgx" />"#;
        assert!(after.text("usrapp/main/main.pjx").contains(entries), "on one line, so that no line number changes");
        assert_eq!(after.text("usrapp/other/other.pjx"), before.text("usrapp/other/other.pjx"));
    }

    #[test]
    fn code_with_the_end_of_a_cdata_section_is_escaped() {
        let fixture = Fixture::parse("string sA\nsA=\"<]]>&\"");
        let text = fixture.text("usrapp/main/start.pgx");
        assert!(text.contains("    <Code>begin\nsA=&quot;&lt;]]&gt;&amp;&quot;\nend</Code>\n"), "{text}");
    }
}
