//! Uses of a name in its file, separated into reads and writes.

use val3_analysis::db::Db;
use val3_analysis::occurrences::{Usage, occurrences};
use val3_syntax::TextRange;

use crate::FilePosition;
use crate::navigate::name_at;

/// A use of the name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Highlight {
    /// Range of the name.
    pub range: TextRange,
    /// Whether it is assigned or declared here.
    pub is_write: bool,
}

/// All uses of the name at a position, in the same file.
pub fn highlights(db: &dyn Db, at: FilePosition) -> Vec<Highlight> {
    let Some((project, found)) = name_at(db, at) else { return Vec::new() };
    let same = occurrences(db, project, at.file).iter().filter(|occurrence| occurrence.symbol == found.symbol);
    same.map(|occurrence| Highlight { range: occurrence.range, is_write: occurrence.usage != Usage::Read }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::MarkedListing;

    /// Lines of all uses, with `w` for a write.
    fn shown(listing: &str) -> String {
        let marked = MarkedListing::new(listing);
        let text: &str = marked.at().file.text(marked.db());
        let found = highlights(marked.db(), marked.at()).into_iter().map(|found| {
            let before = &text[..usize::from(found.range.start())];
            let line = text.lines().nth(before.matches('\n').count()).unwrap_or("").trim();
            format!("{}{line}", if found.is_write { "w " } else { "" })
        });
        found.collect::<Vec<_>>().join(" | ")
    }

    #[test]
    fn reads_and_writes_are_distinguished() {
        let found = shown("num nA\nn$0A=1\nputln(nA)\nnA=nA+1");
        assert_eq!(found, "w nA=1 | putln(nA) | w nA=nA+1 | nA=nA+1");
    }

    #[test]
    fn an_argument_by_reference_counts_as_a_write() {
        let found = shown("num nA\ncall fill(n$0A)\nputln(nA)\nprogram fill(num& x_n)\nbegin\nend");
        assert_eq!(found, "w call fill(nA) | putln(nA)");
    }

    #[test]
    fn parts_of_a_variable_are_highlighted() {
        let found = shown("point pA\np$0A.trsf.x=1\nputln(pA.trsf.y)");
        assert_eq!(found, "w pA.trsf.x=1 | putln(pA.trsf.y)");
    }

    #[test]
    fn tasks_are_highlighted() {
        let found =
            shown("taskCreate \"a\",1,other()\ntaskKill(\"$0a\")\ntaskKill(\"b\")\nprogram other()\nbegin\nend");
        assert_eq!(found, "w taskCreate \"a\",1,other() | taskKill(\"a\")");
    }

    #[test]
    fn declarations_in_the_same_file_are_highlighted() {
        let found = shown("program start()\n  num l_i\nbegin\n  l_$0i=1\nend");
        assert_eq!(found, "w <Local name=\"l_i\" type=\"num\" xsi:type=\"array\" size=\"1\" /> | w l_i=1");
    }
}
