//! Comments that silence findings, as `val3 check --add-suppressions` writes them.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use rowan::NodeOrToken;
use val3_analysis::db::{Db, File, FileEdit};
use val3_analysis::items::suppressions::{Suppression, SuppressionExtent, suppressions};
use val3_analysis::items::unlisted::is_program;
use val3_analysis::items::{parse, program};
use val3_syntax::view::View;
use val3_syntax::{SyntaxKind, TextRange, TextSize};

use super::can_be_silenced;
use crate::diagnostic::{Diagnostic, Fix};
use crate::fix::Site;

/// Changes that silence findings: one for each code line with findings, and one for a program with findings outside of
/// its code lines. Findings that no comment can silence are omitted.
pub(crate) fn silencing(db: &dyn Db, found: &[Diagnostic]) -> Vec<Fix> {
    let mut places: BTreeMap<(&str, TextSize, bool), (SilencedCode, BTreeSet<&str>)> = BTreeMap::new();
    for diagnostic in found.iter().filter(|diagnostic| can_be_silenced(diagnostic.rule)) {
        let file = diagnostic.place.file;
        if let Some(place) = place(db, file, diagnostic.place.range.start()) {
            let order = (file.path(db).as_str(), place.range.start(), place.is_line);
            places.entry(order).or_insert((place, BTreeSet::new())).1.insert(diagnostic.rule.code);
        }
    }
    let fixes = places.into_values().filter_map(|(place, codes)| {
        let codes: Vec<&str> = codes.into_iter().collect();
        Some(Fix::safe(format!("silence {}", codes.join(", ")), vec![place.comment(db, &codes.join(", "))?]))
    });
    fixes.collect()
}

/// Part of a program that a comment silences.
struct SilencedCode {
    file: File,
    /// Line of code; for a whole program, the start of the line below `begin`.
    range: TextRange,
    is_line: bool,
}

/// Part that silences a finding at `at`. A comment for one line is written above a line of code.
fn place(db: &dyn Db, file: File, at: TextSize) -> Option<SilencedCode> {
    if !is_program(file.path(db).as_str()) {
        return None;
    }
    let text = file.text(db);
    let parse = parse(db, file);
    let code = program::code(parse.view())?;
    let begin = begin(code)?;
    let line = content(text, at)?;
    let is_line = line.start() > begin.start()
        && code.range().contains(line.start())
        && !text.get(Range::from(line))?.starts_with("//");
    Some(SilencedCode { file, range: if is_line { line } else { start_of_next_line(text, begin.end())? }, is_line })
}

/// First byte of the line after `at`.
fn start_of_next_line(text: &str, at: TextSize) -> Option<TextRange> {
    let rest = text.get(at.into()..)?;
    let next = at + TextSize::of(rest.split_inclusive('\n').next()?);
    Some(TextRange::at(next, TextSize::from(1)))
}

/// Range of the line that contains `at`, without blanks at its ends; `None` for a blank line.
fn content(text: &str, at: TextSize) -> Option<TextRange> {
    let start = text.get(..at.into())?.rfind(['\n', '\r']).map_or(0, |end| end + 1);
    let line = text.get(start..)?.split(['\n', '\r']).next()?;
    let blanks = line.len() - line.trim_start().len();
    Some(TextRange::at(TextSize::try_from(start + blanks).ok()?, TextSize::of(line.trim())))
}

/// Word that opens the code.
fn begin(code: View<'_>) -> Option<TextRange> {
    code.children_with_tokens().find_map(|child| match child {
        NodeOrToken::Node(node) => begin(node),
        NodeOrToken::Token(token) => (token.kind() == SyntaxKind::BEGIN_KW).then(|| token.range()),
    })
}

impl SilencedCode {
    /// Edit that silences these rules: they are added to a comment that applies here, or to a new comment.
    fn comment(&self, db: &dyn Db, codes: &str) -> Option<FileEdit> {
        let site = Site::new(db, self.file, self.range, None);
        if let Some(last) =
            suppressions(db, self.file).iter().find(|it| self.is_under(it)).and_then(|it| it.rules.last())
        {
            return Some(site.write(TextRange::empty(last.range.end()), &format!(", {codes}")));
        }
        match self.is_line {
            true => Some(site.line_before(&format!("//val3: allow({codes})"))),
            false => site.insert_line(&format!("  //val3: allow-program({codes})")),
        }
    }

    fn is_under(&self, suppression: &Suppression) -> bool {
        match suppression.scope {
            SuppressionExtent::Line(_) => self.is_line && suppression.covers(self.range.start()),
            SuppressionExtent::Program => !self.is_line,
            SuppressionExtent::Misplaced | SuppressionExtent::Unreadable => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};
    use val3_test::{Fixture, ROOT};

    use crate::testing::{check_files, silenced_files};

    /// Checks the code of `start` with comments for all findings, after which programs have no findings left.
    #[track_caller]
    fn check(change: fn(&str) -> String, listing: &str, expected: Expect) {
        let files = Fixture::parse(listing).files.into_iter();
        let files: Vec<_> = files.map(|(path, text)| (format!("{ROOT}/{path}"), change(&text).into_bytes())).collect();
        let silenced = silenced_files(&files);
        let left = check_files(&silenced).into_iter().filter(|found| found.file.ends_with(".pgx"));
        assert_eq!(left.collect::<Vec<_>>(), []);
        let (_, program) = silenced.iter().find(|(path, _)| path.ends_with("start.pgx")).unwrap();
        let text = str::from_utf8(program).unwrap();
        let code = text.split_once("<Code>").unwrap().1.split_once("</Code>").unwrap().0;
        expected.assert_eq(&code.replace('\r', "␍"));
    }

    const LISTING: &str = "num nA\n\nprogram start()\n  num l_nB\nbegin\n  // left over\n  if nA==nX\n    nB=nA*true\n  endIf\n\
                           //val3: allow(V0101)\n  nC=nD==2\n  nC=1\nend\n";

    #[test]
    fn comments_are_inserted_for_lines_and_programs() {
        check(
            str::to_owned,
            LISTING,
            expect![[r#"
            <![CDATA[begin
              // left over
              //val3: allow(V0101)
              if nA==nX
                //val3: allow(V0101, V0201)
                nB=nA*true
              endIf
            //val3: allow(V0101)
              nC=nD==2
              nC=1
            end]]>"#]],
        );
        check(
            |text| text.replace('\n', "\r\n"),
            LISTING,
            expect![[r#"
            <![CDATA[begin␍
              // left over␍
              //val3: allow(V0101)␍
              if nA==nX␍
                //val3: allow(V0101, V0201)␍
                nB=nA*true␍
              endIf␍
            //val3: allow(V0101)␍
              nC=nD==2␍
              nC=1␍
            end]]>"#]],
        );
    }
}
