//! Edits for lint fixes, in addition to [`Site`].

use val3_analysis::body::ExprId;
use val3_analysis::db::FileEdit;
use val3_syntax::{TextRange, TextSize};

use super::ProgramView;
use crate::fix::Site;

impl<'db> ProgramView<'db> {
    /// Creates a fix location of the program.
    pub(crate) fn site(&self, range: TextRange) -> Site<'db> {
        Site::new(self.db, self.file, range, None)
    }

    /// Replaces `range` with raw text of the file, without escaping.
    pub(crate) fn write(&self, range: TextRange, text: &str) -> FileEdit {
        self.site(range).write(range, text)
    }

    /// Location of the operator `op` between two operands; `None` if it is spelled with entity references.
    pub(crate) fn operator(&self, left: ExprId, right: ExprId, op: &str) -> Option<TextRange> {
        let (start, end) = (self.range(left).end(), self.range(right).start());
        let between = self.file.text(self.db).get(usize::from(start)..usize::from(end))?;
        let at = TextSize::try_from(between.find(op)?).ok()?;
        Some(TextRange::at(start + at, TextSize::try_from(op.len()).ok()?))
    }
}

#[cfg(test)]
mod tests {
    use camino::Utf8PathBuf;
    use val3_analysis::db::FileEdit;
    use val3_analysis::load::load;
    use val3_analysis::system::Memory;
    use val3_test::{Fixture, ROOT};

    use crate::settings::{RuleSelection, WorkspaceSettings};
    use crate::{check_unit, units};

    /// Code of `start` after the first fix of `rule`.
    fn fixed(rule: &str, listing: &str, change: impl Fn(String) -> String) -> String {
        let fixture = Fixture::parse(listing);
        let files = fixture.files.iter().map(|(path, text)| {
            let text = if path.ends_with(".pgx") { change(text.clone()) } else { text.clone() };
            (Utf8PathBuf::from(format!("{ROOT}/{path}")), text.into_bytes())
        });
        let workspace = load(&Memory::new(files), &[Utf8PathBuf::from(ROOT)]).unwrap();
        let db = &workspace.db;
        let settings = WorkspaceSettings::new(db, &workspace.projects, &RuleSelection::default()).unwrap();
        let units = units(db, &workspace.projects);
        let found = units.into_iter().flat_map(|unit| check_unit(db, unit, &settings).findings);
        let fix =
            found.filter(|diagnostic| diagnostic.rule.code == rule).find_map(|diagnostic| diagnostic.fix).unwrap();
        let edit = &fix.edits[0];
        let text = FileEdit::apply_all(edit.file.text(db), [edit]);
        let start = text.find("begin").unwrap();
        text[start..].split("end]]>").next().unwrap().split("\nend").next().unwrap().to_owned()
    }

    #[test]
    fn inserted_lines_keep_indentation_and_line_ends() {
        let latch = "dio d\njoint j\nif d==true\n  setLatch(d)\n  wait(getLatch(j))\nendIf";
        let code = fixed("V0326", latch, |text| text.replace('\n', "\r\n"));
        let lines: Vec<&str> = code.split("\r\n").collect();
        let armed = lines.iter().position(|line| line.contains("setLatch")).unwrap();
        assert_eq!(lines[armed + 1], lines[armed].replace("setLatch(d)", "delay(0)"));
        let key = "if 1<get()\n  wait(getKey()!=-1)\nendIf";
        let code = fixed("V0328", key, |text| text);
        assert!(code.contains("  getKey()\n"), "{code:?}");
    }

    #[test]
    fn operators_are_escaped_as_in_the_file() {
        let plain = fixed("V0232", "wait(getMoveId()==2)", |text| text);
        assert!(plain.contains("wait(getMoveId()>=2)"), "{plain:?}");
        let escape = |text: String| text.replace("<![CDATA[", "").replace("]]>", "");
        let escaped = fixed("V0232", "wait(getMoveId()==2)", escape);
        assert!(escaped.contains("wait(getMoveId()&gt;=2)"), "{escaped:?}");
    }
}
