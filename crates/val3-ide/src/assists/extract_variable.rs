//! Extracts the selected expression into a new local variable.

mod occurrences;

use smol_str::SmolStr;
use val3_analysis::body::{Expr, ExprId, StmtKind};
use val3_analysis::db::{Db, Project};
use val3_analysis::items::project::{fields, items, resolve_type};
use val3_analysis::ty::{Base, Ty};
use val3_lang::types::{BaseType, Container};
use val3_syntax::TextRange;

use super::context::Context;
use super::evaluation::Evaluation;
use super::expected::type_name;
use super::precedence::needs_parentheses;
use super::{AssistKind, Assists};
use crate::declare::{self, NewVariable, free};
use crate::edit::SourceChange;
use occurrences::Occurrences;

const GROUP: &str = "Extract variable";
const ID: &str = "extract-variable";
const TITLE: &str = "Extract into a local variable";

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    context.code()?;
    let id = apart(context, context.expr_at(context.trimmed()?)?);
    let evaluation = Evaluation::new(context);
    let (block, at) = evaluation.stmt(id)?;
    let stmt = block.get(at)?;
    let ty = evaluation.inference.ty(id);
    if context.is_broken(stmt.range) || ty.is_unknown() || stmt.kind == StmtKind::Expr(id) {
        return None;
    }
    let reason = obstacle(context, &evaluation, id, ty).or_else(|| context.starts_no_line(stmt.range.start()));
    if let Some(reason) = reason {
        assists.refuse(Some(GROUP), ID, AssistKind::Extract, TITLE, reason);
        return None;
    }
    let found = Occurrences::of(context, &evaluation, id);
    assists.add_in(Some(GROUP), ID, AssistKind::Extract, TITLE, || {
        change(context, &evaluation, id, &Occurrences::single(context.body(), id, stmt))
    });
    if let Some(found) = found {
        let title = format!("Extract {} occurrences into a local variable", found.ranges.len());
        assists.add_in(Some(GROUP), "extract-variable-all", AssistKind::Extract, title, || {
            change(context, &evaluation, id, &found)
        });
    }
    Some(())
}

/// Reason why the value cannot be assigned to a variable before the statement; `None` if it can.
fn obstacle(context: &Context<'_>, evaluation: &Evaluation<'_>, id: ExprId, ty: Ty) -> Option<String> {
    if !evaluation.is_value(id) {
        return Some("The variable itself is needed here, not its value".to_owned());
    }
    if ty.container != Container::Element || !can_be_local(context.db, ty.base) {
        return Some(format!("A local variable cannot hold a copy of `{}`", ty.display(context.db)));
    }
    // A field may have a user type that only its own type's project lists.
    let name = type_name(context, ty.base, false);
    if resolve_type(&context.items().types, &name).is_none_or(|base| !base.same_as(ty.base)) {
        return Some(format!("The project does not list the type `{name}`"));
    }
    evaluation.movable(id).err().map(|error| error.0)
}

/// Nesting limit of user types within user types.
const NESTING: u8 = 8;

/// Whether a local of this type stores everything that an assignment copies. Inputs and outputs have a link in
/// addition, and so do tools.
pub(crate) fn can_be_local(db: &dyn Db, base: Base) -> bool {
    can_be_nested(db, base, NESTING)
}

fn can_be_nested(db: &dyn Db, base: Base, nesting: u8) -> bool {
    match base {
        Base::Builtin(BaseType::Screen | BaseType::Tool, _) | Base::Unknown => false,
        Base::Builtin(ty, _) => !ty.is_linkable() && !ty.is_enumeration(),
        Base::User(project) => nesting > 0 && fields_of(db, project).all(|base| can_be_nested(db, base, nesting - 1)),
    }
}

fn fields_of(db: &dyn Db, project: Project) -> impl Iterator<Item = Base> {
    let types = &items(db, project).types;
    let base = |name: &SmolStr| resolve_type(types, name).unwrap_or(Base::Unknown);
    fields(db, project).values().map(move |field| base(&field.decl.type_name))
}

fn change(context: &Context<'_>, evaluation: &Evaluation<'_>, id: ExprId, found: &Occurrences) -> Option<SourceChange> {
    let type_name = type_name(context, evaluation.inference.ty(id).base, false);
    let name = name(context, id, &type_name);
    let value = value(context, evaluation, id);
    let declared = declare::locals(context.db, context.file, &[&NewVariable::single(&name, &type_name)])?;
    let equals = if context.style().around_assignment { " = " } else { "=" };
    let line = format!("{name}{equals}{value}{}{}", context.line_end(), context.indentation(found.before));
    let assigned = context.replace(TextRange::empty(found.before), line);
    let replaced = found.ranges.iter().map(|range| context.replace(*range, name.as_str()));
    let change = SourceChange::of([declared, assigned].into_iter().chain(replaced));
    Some(change.with_new_name(context.file, found.before, &name))
}

/// The expression, without parentheses, unless they separate it from an adjacent word with which a name would merge.
fn apart(context: &Context<'_>, id: ExprId) -> ExprId {
    let Expr::Paren(inner) = context.body().expr(id) else { return id };
    let range = std::ops::Range::<usize>::from(context.body().range(id));
    let before = context.text.get(..range.start).is_some_and(|text| text.ends_with(is_in_name));
    let after = context.text.get(range.end..).is_some_and(|text| text.starts_with(is_in_name));
    if before || after { apart(context, *inner) } else { id }
}

/// Whether a name can contain the letter.
fn is_in_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

/// Source of the expression, without parentheses that only its context requires.
fn value<'db>(context: &Context<'db>, evaluation: &Evaluation<'_>, id: ExprId) -> &'db str {
    let body = context.body();
    let inner = body.without_parentheses(id);
    let is_needed = needs_parentheses(body, evaluation.parent(id), id, inner);
    context.slice(body.range(if is_needed { inner } else { id }))
}

/// An unused name that describes the value, in the project's naming convention.
fn name(context: &Context<'_>, id: ExprId, type_name: &str) -> String {
    let options = context.options();
    let base = BaseType::from_file_name(type_name).map_or(type_name, |(ty, _)| ty.name());
    let prefix = options.prefixes.get(base).map_or("", String::as_str);
    let stem = meaning(context, id).map_or_else(|| "Value".to_owned(), |word| capitalised(&word));
    free(&format!("{}{prefix}{stem}", options.local_prefix), |name| context.is_taken(name))
}

/// Field or instruction that yields the value.
fn meaning(context: &Context<'_>, id: ExprId) -> Option<SmolStr> {
    let body = context.body();
    match body.expr(body.without_parentheses(id)) {
        Expr::Field { field, .. } => Some(field.clone()),
        Expr::Call(callee, _) => match body.expr(*callee) {
            Expr::Name(name) => Some(name.trim_start_matches('$').into()),
            Expr::Path { item, .. } => Some(item.trim_start_matches('$').into()),
            _ => None,
        },
        _ => None,
    }
}

fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters).collect()
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered, refused};

    const ID: &str = "extract-variable";

    #[test]
    fn the_value_is_assigned_before_the_statement() {
        check(
            ID,
            "num nA\nnum nB\n  // why\n  nB=$0(nA+1)$0*2",
            expect![[r#"
                usrapp/main/start.pgx
                -    <Code><![CDATA[begin
                -  // why
                -  nB=(nA+1)*2
                +    <Locals>
                +      <Local name="l_nValue" type="num" xsi:type="array" size="1" />
                +    </Locals>
                +    <Code><![CDATA[begin
                +  // why
                +  l_nValue=nA+1
                +  nB=l_nValue*2
            "#]],
        );
    }

    #[test]
    fn the_name_follows_from_the_value() {
        for (line, wanted) in [
            ("nA=$0distance(pA,pA)$0", "l_nDistance"),
            ("trA=$0pA.trsf$0", "l_trTrsf"),
            ("putln($0\"a\"+sA$0)", "l_sValue"),
            ("if $0nA==1$0\nendIf", "l_bValue"),
            ("call other($0appro(pA,trA)$0,nA)", "l_pAppro"),
        ] {
            let listing = format!(
                "num nA\npoint pA\ntrsf trA\nstring sA\n{line}\nprogram other(point x_p, num& x_n)\nbegin\nend"
            );
            assert!(super::super::testing::done(&listing, ID).contains(&format!("name=\"{wanted}\"")), "{line}");
        }
    }

    #[test]
    fn the_name_and_a_word_stay_apart() {
        let found = super::super::testing::done("num nA\nif$0(nA==1)$0\nendIf", ID);
        assert!(found.contains("+l_bValue=nA==1\n+if(l_bValue)\n"), "{found}");
    }

    #[test]
    fn all_occurrences_are_replaced() {
        let all = "extract-variable-all";
        check(
            all,
            "num nA\nnum nB\nnum nC\nnB=nA*2\nnC=$0nA * 2$0\nif nC<(nA*2)\n  nC=nC+1\nendIf\nnA=nA*2\nnC=nA*2",
            expect![[r#"
                usrapp/main/start.pgx
                -    <Code><![CDATA[begin
                -nB=nA*2
                -nC=nA * 2
                -if nC<(nA*2)
                -  nC=nC+1
                -endIf
                -nA=nA*2
                +    <Locals>
                +      <Local name="l_nValue" type="num" xsi:type="array" size="1" />
                +    </Locals>
                +    <Code><![CDATA[begin
                +l_nValue=nA * 2
                +nB=l_nValue
                +nC=l_nValue
                +if nC<l_nValue
                +  nC=nC+1
                +endIf
                +nA=l_nValue
            "#]],
        );
        for (line, count) in [
            ("nA=$02*3$0\nput(6)\nput(2*3)\nput(10-4)\nput((2 * 3))", 3),
            ("put($0\"ab\"$0)\nput(\"a\"+\"b\")\nput(\"ab\")", 2),
            ("nA=$0-(-1)$0\nput(1)\nput(-(-1))\nput(((-(-1))))", 3),
            ("bA=$0true$0\nbA=!(false) or false\nbA=true", 2),
        ] {
            let done = super::super::testing::done(&format!("num nA\nbool bA\n{line}"), all);
            let lines = done.lines().filter(|line| line.starts_with('+') && line.contains("Value"));
            assert_eq!(lines.count(), count + 2, "{line}: {done}");
        }
        for code in [
            "nB=$0nA*2$0\nnA=1\nnB=nA*2",
            "nB=$0nA*2$0\ncall other()\nnB=nA*2",
            "nB=$0nA*2$0\ndelay(1)\nnB=nA*2",
            "nB=$0nA*2$0\nwhile nA*2>nB\nendWhile",
        ] {
            assert_eq!(offered(&format!("num nA\nnum nB\n{code}\nprogram other()\nbegin\nend"), all), None, "{code}");
        }
    }

    #[test]
    fn code_of_s6_is_extracted() {
        check(
            ID,
            "num nZ\nbool bA\n=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\">\r\n  <program name=\"start\" public=\"false\">\r\n    <paramSection/>\r\n    <localSection/>\r\n    <source><code>begin\r\n  if $0nZ&lt;2$0 and bA\r\n  endIf\r\nend</code></source>\r\n  </program>\r\n</programList>\r\n",
            expect![[r#"
                usrapp/main/start.pgx
                -    <localSection/>
                -    <source><code>begin
                -  if nZ&lt;2 and bA
                +    <localSection>
                +      <local name="l_bValue" type="bool" size="1" />
                +    </localSection>
                +    <source><code>begin
                +  l_bValue=nZ&lt;2
                +  if l_bValue and bA
            "#]],
        );
    }

    #[test]
    fn a_value_that_would_be_another_one_is_refused() {
        for (code, reason) in [
            ("while $0nA<1$0\nendWhile", "every pass"),
            ("do\nuntil $0nA<1$0", "every pass"),
            ("if bA\nelseIf $0nA<1$0\nendIf", "only if"),
            ("wait($0nA==1$0)", "every cycle"),
            ("wait(bA and ($0nA+1$0)==2)", "right side"),
            ("bA=watch($0nA==1$0,2)", "every cycle"),
            ("for nA=0 to $0nB+1$0\nendFor", "how often"),
            ("switch nA\ncase $0nB+1$0\nbreak\nendSwitch", "compared only"),
            ("bA=bA and $0nA==1$0", "right side"),
            ("bA=bA or ($0nA==1$0)", "right side"),
            ("nA=get()+$0get()$0", "first"),
            ("nA=nB+$0get()$0", "first"),
            ("nA=get()+$0nB*2$0", "first"),
            ("call other($0nA$0,1)", "variable itself"),
            ("$0nA$0=1", "variable itself"),
            ("nA=$0nC$0[1]", "variable itself"),
            ("bA=$0dA$0", "cannot hold"),
            ("movej(pA,$0tA$0,mA)", "cannot hold"),
            ("wA.inner=$0wA.inner$0", "does not list"),
        ] {
            let listing = format!(
                "type Wrap \"Disk://Wrap/Wrap.pjx\"\nprivate Wrap wA\nnum nA\nnum nB\nnum nC[2]\nbool bA\ndio dA\npoint pA\ntool tA\nmdesc mA\n{code}\nprogram other(num& x_n, num x_o)\nbegin\nend\n--- Wrap\ntype Inner \"Disk://Inner/Inner.pjx\"\npublic Inner inner\n--- Inner\npublic num nValue"
            );
            let found = refused(&listing, ID);
            assert!(found.as_ref().is_some_and(|found| found.contains(reason)), "{code}: {found:?}");
        }
    }

    #[test]
    fn values_that_are_computed_first_are_extracted() {
        for code in [
            "nA=$0get()$0+get()",
            "nA=1+$0get()$0",
            "bA=$0(nA==1)$0 and bA",
            "wait(nA==1)\nif $0bA$0\nendIf",
            "bA=watch(bA,$0nA+1$0)",
            "switch $0nA+1$0\ncase 1\nbreak\nendSwitch",
            "nC[$0nA+1$0]=2",
            "call other(nC[$0nA+1$0],nB)",
            "call other(nA,$0nB+1$0)",
            "taskCreate \"a\",$0nA+1$0,other(nA,nB)",
        ] {
            let listing =
                format!("num nA\nnum nB\nnum nC[2]\nbool bA\n{code}\nprogram other(num& x_n, num x_o)\nbegin\nend");
            assert!(offered(&listing, ID).is_some(), "{code}: {:?}", refused(&listing, ID));
        }
    }

    #[test]
    fn other_selections_are_not_offered() {
        for code in ["nA=$0nB+$0nC", "$0nA=1$0", "$0get()$0", "nA=nB$0+1", "nA=$0nB+$0"] {
            assert_eq!(offered(&format!("num nA\nnum nB\nnum nC\n{code}"), ID), None, "{code}");
        }
    }
}
