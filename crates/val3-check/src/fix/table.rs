//! Which rule mends which fault; a fault without a line here has no fix.

use val3_analysis::problem::ProblemKind;
use val3_syntax::error::SyntaxErrorKind;

use super::{Site, rename};
use crate::diagnostic::Fix;
use crate::rules::{
    assignment_in_expression, comment_after_code, father_missing, foreign_spelling, missing_break,
    program_name_mismatch, unclosed_block, unclosed_bracket, unknown_instruction, unknown_program, unmatched_bracket,
    xml_text,
};

/// The fix of a fault of the text.
pub(crate) fn of_syntax(kind: &SyntaxErrorKind, site: &Site<'_>) -> Option<Fix> {
    use SyntaxErrorKind as Kind;
    match kind {
        Kind::UnknownEntity { text } => xml_text::fix(site, text),
        Kind::UnclosedBracket { missing } => unclosed_bracket::fix(site, *missing),
        Kind::UnmatchedBracket { bracket } => unmatched_bracket::fix(site, *bracket),
        Kind::UnclosedBlock { missing, .. } => unclosed_block::fix(site, missing),
        Kind::MissingBreak => missing_break::fix(site),
        Kind::AssignmentInExpression => assignment_in_expression::fix(site),
        Kind::CommentAfterCode => comment_after_code::fix(site),
        Kind::ForeignSpelling { instead, .. } => foreign_spelling::fix(site, instead),
        _ => None,
    }
}

/// The fix of a fault that the analysis found.
pub(crate) fn of_problem(kind: &ProblemKind, site: &Site<'_>) -> Option<Fix> {
    use ProblemKind as Kind;
    match kind {
        Kind::UnknownName { name, near } => rename(site, name, near.as_deref()),
        Kind::UnknownProgram { name, near, is } => unknown_program::fix(site, name, near.as_deref(), *is),
        Kind::UnknownInstruction { name, near, is } => unknown_instruction::fix(site, name, near.as_deref(), *is),
        Kind::UnknownLibrary { alias, near } => rename(site, alias, near.as_deref()),
        Kind::UnknownType { name, near } => rename(site, name, near.as_deref()),
        Kind::UnknownField { field, near, .. } => rename(site, field, near.as_deref()),
        Kind::ProgramNameMismatch { program, file } => program_name_mismatch::fix(site, program, file),
        Kind::UnknownValueAttribute { attribute, near, .. } => rename(site, attribute, near.as_deref()),
        Kind::UnknownUserField { field, near, .. } => rename(site, field, near.as_deref()),
        Kind::FatherMissing { father, near } => father_missing::fix(site, father, near.as_deref()),
        Kind::IoLinkUnknown { link, near } => rename(site, link, near.as_deref()),
        Kind::LibraryItemUnknown { item, near, .. } => rename(site, item, near.as_deref()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};
    use val3_test::{Fixture, ROOT};

    use crate::testing::{fixed_files, offered_fixes};

    /// The fixes of a listing, and the code of `start` with all of them, or the file that the last change names.
    fn check_as(change: impl Fn(&str) -> String, listing: &str, expect: Expect) {
        let fixture = Fixture::parse(listing);
        let files = fixture.files.iter().map(|(path, text)| (format!("{ROOT}/{path}"), change(text).into_bytes()));
        let files: Vec<_> = files.collect();
        let mut shown = String::new();
        for fix in offered_fixes(&files) {
            shown += &format!("{} {}{}\n", fix.code, fix.title, if fix.safe { "" } else { " (unsafe)" });
        }
        for ((_, before), (_, after)) in files.iter().zip(fixed_files(&files)) {
            let (before, after) = (str::from_utf8(before).unwrap(), str::from_utf8(&after).unwrap());
            if before != after {
                shown += &code(after).replace('\r', "␍");
            }
        }
        expect.assert_eq(&shown);
    }

    fn check(listing: &str, expect: Expect) {
        check_as(str::to_owned, listing, expect);
    }

    /// What stands around `begin` and `end`; other files as they are.
    fn code(text: &str) -> &str {
        let start = text.find("begin").unwrap_or(0);
        text[start..].split("</Code>").next().unwrap().trim_end_matches("]]>")
    }

    #[test]
    fn names() {
        check(
            "num nCount\nstring sName\n\nnCuont=1\nsNmae=\"a\"\nputnl(nCount)",
            expect![[r#"
            V0101 write `nCount` (unsafe)
            V0101 write `sName` (unsafe)
            V0103 write `putln` (unsafe)
            begin

            nCount=1
            sName="a"
            putln(nCount)
            end"#]],
        );
        check(
            "library part \"Disk://part/part.pjx\"\n\nptra:nWeight=part:nWieght\n\n--- part\npublic num nWeight",
            expect![[r#"
            V0601 write `nWeight` (unsafe)
            begin

            ptra:nWeight=part:nWeight
            end"#]],
        );
        check(
            "trsf trA\n\ntrA.xx=1\n\nprogram pick()\nbegin\nend\n\nprogram place()\nbegin\n  call pcik()\nend",
            expect![[r#"
            V0102 write `pick` (unsafe)
            V0107 write `rx` (unsafe)
            begin

            trA.rx=1
            endbegin
              call pick()
            end"#]],
        );
    }

    #[test]
    fn calls() {
        check(
            "call putln(\"a\")\n  pick()\n\nprogram pick()\nbegin\nend",
            expect![[r#"
            V0102 remove `call`
            V0103 write `call`
            begin
            putln("a")
              call pick()
            end"#]],
        );
    }

    #[test]
    fn blocks() {
        check(
            "num n\n\nif n==1\n  n=2\nn=3",
            expect![[r#"
            V0014 write `endIf` (unsafe)
            begin

            if n==1
              n=2
            endIf
            n=3
            end"#]],
        );
        check(
            "num n\n\nwhile n==1\n  if n==2\n    n=2\nendWhile",
            expect![[r#"
            V0014 write `endIf` (unsafe)
            begin

            while n==1
              if n==2
                n=2
              endIf
            endWhile
            end"#]],
        );
        check(
            "num n\n\nif n==1\n  n=2\nendWhile\nn=3",
            expect![[r#"
            V0014 write `endIf` (unsafe)
            begin

            if n==1
              n=2
            endIf
            n=3
            end"#]],
        );
        check(
            "num n\n\nswitch n\n  case 1\n    n=2\n  default\n    n=3\nendSwitch",
            expect![[r#"
            V0016 close the branch with `break`
            V0016 close the branch with `break`
            begin

            switch n
              case 1
                n=2
              break
              default
                n=3
              break
            endSwitch
            end"#]],
        );
    }

    #[test]
    fn other_languages() {
        let listing = "num n\n\nIF n<>1 && n!=2 then\n  n=1\nelse if not n==1\n  n=2\nend if";
        check(
            listing,
            expect![[r#"
            V0701 write `if`
            V0026 write `!=`
            V0026 write `elseIf`
            V0026 write `endIf`
            begin

            if n!=1 && n!=2 then
              n=1
            elseIf not n==1
              n=2
            endIf
            end"#]],
        );
        let old = |text: &str| {
            text.replace("<![CDATA[", "").replace("]]>", "").replace("<>", "&lt;&gt;").replace("&&", "&amp;&amp;")
        };
        check_as(
            old,
            listing,
            expect![[r#"
            V0701 write `if`
            V0026 write `!=`
            V0026 write `elseIf`
            V0026 write `endIf`
            begin

            if n!=1 &amp;&amp; n!=2 then
              n=1
            elseIf not n==1
              n=2
            endIf
            end"#]],
        );
        check(
            "num n\nbool b\n\nif n=1\n  b=n=2\nendIf",
            expect![[r#"
            V0023 write `==`
            begin

            if n==1
              b=n=2
            endIf
            end"#]],
        );
    }

    #[test]
    fn brackets() {
        check(
            "num n[3]\n\nputln(n[1)\nputln(n[1]\nn[1]=2)",
            expect![[r#"
            V0011 write `]` (unsafe)
            V0011 write `)` (unsafe)
            V0012 remove `)` (unsafe)
            begin

            putln(n[1])
            putln(n[1])
            n[1]=2
            end"#]],
        );
    }

    #[test]
    fn comments() {
        check(
            "num n\n\nif n==1\n  n=2   // & so <on>\nendIf",
            expect![[r#"
            V0024 move the comment above the line
            begin

            if n==1
              // & so <on>
              n=2
            endIf
            end"#]],
        );
        let old = |text: &str| {
            text.replace("<![CDATA[", "")
                .replace("]]>", "")
                .replace("& so <on>", "&amp; so &lt;on>")
                .replace('\n', "&#13;\n")
        };
        let old = move |text: &str| match text.split_once("<Code>") {
            Some((head, code)) => format!("{head}<Code>{}", old(code)),
            None => text.to_owned(),
        };
        check_as(
            old,
            "num n\n\nif n==1\n  n=2   // & so <on>\nendIf",
            expect![[r#"
            V0024 move the comment above the line
            begin&#13;
            &#13;
            if n==1&#13;
              // &amp; so &lt;on>&#13;
              n=2&#13;
            endIf&#13;
            end"#]],
        );
        check_as(
            |text| text.replace("\n", "\r\n"),
            "num n\n\nif n==1\n  n=2 // a\nendIf",
            expect![[r#"
                V0024 move the comment above the line
                begin␍
                ␍
                if n==1␍
                  // a␍
                  n=2␍
                endIf␍
                end"#]],
        );
    }
}
