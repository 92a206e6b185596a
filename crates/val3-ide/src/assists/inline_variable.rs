//! Replaces a local variable by its assigned expression.

use smol_str::SmolStr;
use val3_analysis::body::{Expr, ExprId, Stmt, StmtKind};
use val3_analysis::effects::{Access, AccessKind, RootVariable};
use val3_analysis::items::declarations;
use val3_analysis::items::program::LocalDecl;
use val3_analysis::items::project::resolve_type;
use val3_syntax::{SyntaxKind, TextSlice};

use super::context::Context;
use super::evaluation::{Evaluation, is_loop};
use super::lines::whole_lines;
use super::precedence::needs_parentheses;
use super::stability::Dependencies;
use super::{AssistKind, Assists};
use crate::RefactoringError;
use crate::declare;
use crate::edit::SourceChange;

const ID: &str = "inline-variable";

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let token = context.token().filter(|token| token.kind() == SyntaxKind::IDENT)?;
    let Expr::Name(name) = context.body().expr(context.expr_at(token.text_range())?) else { return None };
    let local = context.header().locals.iter().find(|local| local.name == *name)?;
    let evaluation = Evaluation::new(context);
    let title = format!("Inline variable `{name}`");
    match Inlining::of(context, &evaluation, local) {
        Ok(inlining) => assists.add(ID, AssistKind::Inline, title, || inlining.change()),
        Err(reason) => assists.refuse(None, ID, AssistKind::Inline, title, reason),
    }
    Some(())
}

/// A variable that is assigned only once.
struct Inlining<'c, 'db> {
    context: &'c Context<'db>,
    evaluation: &'c Evaluation<'db>,
    name: &'c SmolStr,
    block: &'db [Stmt],
    /// Index of the assignment in `block`.
    at: usize,
    /// Assigned expression.
    value: ExprId,
    reads: Vec<ExprId>,
}

impl<'c, 'db> Inlining<'c, 'db> {
    /// Collects the assignment and the reads. The error is a reason for the user.
    fn of(
        context: &'c Context<'db>,
        evaluation: &'c Evaluation<'db>,
        local: &'c LocalDecl,
    ) -> Result<Self, RefactoringError> {
        let root = RootVariable::Local(local.name.clone());
        let uses: Vec<&Access> = evaluation.effects.all().iter().filter(|access| access.root == root).collect();
        let reads = uses.iter().filter(|access| access.kind == AccessKind::Read).map(|access| access.id);
        let reads: Vec<ExprId> = reads.filter_map(|id| name_in(evaluation, id)).collect();
        let written: Vec<&&Access> = uses.iter().filter(|access| access.kind != AccessKind::Read).collect();
        let [Access { id: target, kind: AccessKind::Write, .. }] = written.as_slice() else {
            return Err(format!("`{}` is set at {} places, not at one", local.name, written.len()).into());
        };
        if reads.is_empty() {
            return Err(format!("`{}` is never read", local.name).into());
        }
        let (block, at, value) = assignment(evaluation, *target)
            .ok_or_else(|| format!("`{}` is not set by a separate assignment", local.name))?;
        let inlining = Self { context, evaluation, name: &local.name, block, at, value, reads };
        inlining.check_type(local)?;
        inlining.check_reads()?;
        inlining.check_text()?;
        inlining.check_value().map(|()| inlining)
    }

    /// Checks that the expression has the variable's type, and that the surrounding code has no syntax errors.
    fn check_type(&self, local: &LocalDecl) -> Result<(), RefactoringError> {
        let ty = self.evaluation.inference.ty(self.value);
        let declared = resolve_type(&self.context.items().types, &local.type_name);
        let is_single = matches!(local.sizes.as_slice(), [] | [1]);
        let is_same = declared.is_some_and(|base| base.builtin() == ty.base.builtin() && base.same_as(ty.base));
        if !is_single || ty.is_unknown() || !is_same {
            return Err(format!("The value has another type than `{}`", self.name).into());
        }
        let code = self.context.code().ok_or_else(|| "The program has no code".to_owned())?;
        match self.context.is_broken(val3_syntax::ast::AstNode::syntax(&code).text_range()) {
            true => Err("Lines of the program cannot be read".into()),
            false => Ok(()),
        }
    }

    /// Checks that the expression can replace the variable at all reads.
    fn check_reads(&self) -> Result<(), RefactoringError> {
        let body = self.evaluation.body;
        let is_list = matches!(body.expr(body.without_parentheses(self.value)), Expr::Struct(_));
        for read in &self.reads {
            let parent = self.evaluation.parent(*read).map(|parent| body.expr(parent));
            let is_part = matches!(parent, Some(Expr::Field { .. } | Expr::Index(..)));
            let takes_place = match parent {
                Some(Expr::Index(base, _)) => base != read,
                Some(Expr::Call(..)) => !is_list || self.evaluation.takes_list(*read),
                Some(_) => !is_list,
                None => true,
            };
            let is_variable = self.evaluation.effects.root(self.value).is_some();
            if !self.evaluation.is_value(*read) || !takes_place || is_part && is_list {
                return Err(format!("`{}` is not used as a plain value everywhere", self.name).into());
            }
            if is_part && !is_variable && matches!(parent, Some(Expr::Field { .. })) {
                return Err(format!("A field of `{}` is read, and its value is no variable", self.name).into());
            }
        }
        Ok(())
    }

    /// Checks that the replaced text does not contain `]]>`, which would end the CDATA section.
    fn check_text(&self) -> Result<(), RefactoringError> {
        if !self.context.is_escaped() && self.reads.iter().any(|read| self.ends_section(*read)) {
            return Err("The code would contain `]]>`, which ends its CDATA section".into());
        }
        Ok(())
    }

    /// Whether the value, in the place of `read`, and the text after it contain `]]>`.
    fn ends_section(&self, read: ExprId) -> bool {
        let value = self.context.slice(self.evaluation.body.range(self.value));
        let rest = self.context.text.part(usize::from(self.evaluation.body.range(read).end())..);
        let start: String = rest.chars().take(2).collect();
        format!("{value}{start}").contains("]]>")
    }

    /// Checks that the expression has the same value at all reads.
    fn check_value(&self) -> Result<(), RefactoringError> {
        let body = self.evaluation.body;
        let later = self.block.part(self.at + 1..);
        let index = |read: &ExprId| later.iter().position(|it| it.range.contains_range(body.range(*read)));
        let places: Option<Vec<usize>> = self.reads.iter().map(index).collect();
        let last = places.and_then(|places| places.into_iter().max());
        let last = last.ok_or_else(|| {
            format!("`{}` is read at a place that this assignment does not always precede", self.name)
        })?;
        if last == 0 && self.is_only_delayed() {
            return Ok(());
        }
        if body.constant(self.value).is_some() {
            return Ok(());
        }
        if self.reads.iter().any(|read| self.is_in_loop(later, *read)) {
            return Err(format!("`{}` is computed outside of a loop and read in it", self.name).into());
        }
        let dependencies = Dependencies::of(self.context, self.evaluation, self.value).ok_or_else(|| {
            "The value has an effect, or depends on more than variables, and would be computed at another time"
                .to_owned()
        })?;
        let kept = dependencies.survive(later.part(..last))
            && later.get(last).is_some_and(|stmt| dependencies.survive_reads_of(stmt));
        match kept {
            true => Ok(()),
            false => Err("Something between may change the value".into()),
        }
    }

    /// Whether the next statement reads the variable once, before anything else.
    fn is_only_delayed(&self) -> bool {
        let next = self.block.get(self.at + 1).map(|stmt| stmt.range);
        let [read] = self.reads.as_slice() else { return false };
        let own = self.evaluation.stmt(*read).and_then(|(block, at)| block.get(at)).map(|stmt| stmt.range);
        own == next && self.evaluation.movable_as(*read, self.value).is_ok()
    }

    fn is_in_loop(&self, stmts: &[Stmt], read: ExprId) -> bool {
        let range = self.evaluation.body.range(read);
        let inner = stmts.iter().flat_map(Stmt::with_inner);
        inner.filter(|stmt| stmt.range.contains_range(range)).any(is_loop)
    }

    fn change(&self) -> Option<SourceChange> {
        let Self { context, evaluation, .. } = self;
        let body = evaluation.body;
        let value = context.slice(body.range(self.value));
        let replaced = self.reads.iter().map(|read| {
            let wrapped = needs_parentheses(body, evaluation.parent(*read), *read, self.value);
            let text = if wrapped { format!("({value})") } else { value.to_owned() };
            context.replace(body.range(*read), text)
        });
        let line = whole_lines(context, self.block.get(self.at)?.range)?;
        let locals = declarations::all_locals(context.db, context.file);
        let local = locals.iter().find(|local| local.name == *self.name)?;
        let gone = [declare::without_local(context.db, context.file, local.element), context.replace(line, "")];
        Some(SourceChange::of(replaced.chain(gone)))
    }
}

/// Name expression at the start of a variable expression.
fn name_in(evaluation: &Evaluation<'_>, place: ExprId) -> Option<ExprId> {
    let mut within = evaluation.body.within(place);
    within.find(|id| matches!(evaluation.body.expr(*id), Expr::Name(_)))
}

/// Block and index of the assignment to `target`, and the assigned value.
fn assignment<'db>(evaluation: &Evaluation<'db>, target: ExprId) -> Option<(&'db [Stmt], usize, ExprId)> {
    let (block, at) = evaluation.stmt(target)?;
    match block.get(at)?.kind {
        StmtKind::Assign { target: found, value } if found == target => {
            let is_chain = matches!(evaluation.body.expr(value), Expr::Assign(..));
            (!is_chain).then_some((block, at, value))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, done, refused};

    const ID: &str = "inline-variable";

    fn listing(code: &str) -> String {
        format!(
            "num nA\nnum nB\nbool bA\nprogram other()\n  num l_n\n  num l_m\nbegin\n{code}\nend\nprogram by(num& x_n)\nbegin\nend"
        )
    }

    #[test]
    fn reads_become_the_value() {
        check(
            ID,
            &listing("  // sum\n  l$0_n=nA+1\n  nB=l_n*2\n  if nB==l_n\n    putln(l_n)\n  endIf"),
            expect![[r#"
                usrapp/main/other.pgx
                -      <Local name="l_n" type="num" xsi:type="array" size="1" />
                -      <Local name="l_m" type="num" xsi:type="array" size="1" />
                -    </Locals>
                -    <Code><![CDATA[begin
                -  // sum
                -  l_n=nA+1
                -  nB=l_n*2
                -  if nB==l_n
                -    putln(l_n)
                +      <Local name="l_m" type="num" xsi:type="array" size="1" />
                +    </Locals>
                +    <Code><![CDATA[begin
                +  // sum
                +  nB=(nA+1)*2
                +  if nB==nA+1
                +    putln(nA+1)
            "#]],
        );
    }

    #[test]
    fn parentheses_are_written_where_they_are_needed() {
        for (value, read, wanted) in [
            ("nA+1", "nB=2*l_n", "nB=2*(nA+1)"),
            ("nA+1", "nB=l_n+2", "nB=nA+1+2"),
            ("nA+1", "nB=2-l_n", "nB=2-(nA+1)"),
            ("nA*2", "nB=2-l_n", "nB=2-nA*2"),
            ("-nA", "nB=2-l_n", "nB=2-(-nA)"),
            ("-nA", "nB=-l_n", "nB=-(-nA)"),
            ("-1", "bA=nB==l_n", "bA=nB==-1"),
            ("(nA+1)", "nB=2*l_n", "nB=2*(nA+1)"),
            ("(nA+1)", "nB=l_n", "nB=(nA+1)"),
            ("nA+1", "nB=(l_n)", "nB=(nA+1)"),
        ] {
            let found = done(&listing(&format!("l$0_n={value}\n{read}")), ID);
            assert!(found.contains(&format!("+{wanted}\n")), "{value} in {read}: {found}");
        }
    }

    #[test]
    fn the_last_local_takes_its_list_along() {
        check(
            ID,
            "program other()\n  string l_s\nbegin\n  l_s=\"<a>\"\n  putln($0l_s)\nend",
            expect![[r#"
            usrapp/main/other.pgx
            -    <Locals>
            -      <Local name="l_s" type="string" xsi:type="array" size="1" />
            -    </Locals>
            -    <Code><![CDATA[begin
            -  l_s="<a>"
            -  putln(l_s)
            +    <Code><![CDATA[begin
            +  putln("<a>")
        "#]],
        );
        check(
            ID,
            "num nZ\n=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\">\r\n  <program name=\"start\" public=\"false\">\r\n    <paramSection/>\r\n    <localSection>\r\n      <local name=\"l_s\" type=\"string\" size=\"1\"/>\r\n    </localSection>\r\n    <source><code>begin\r\n  l_s=&quot;&lt;&quot;\r\n  putln($0l_s)\r\nend</code></source>\r\n  </program>\r\n</programList>\r\n",
            expect![[r#"
                usrapp/main/start.pgx
                -      <local name="l_s" type="string" size="1"/>
                -    </localSection>
                -    <source><code>begin
                -  l_s=&quot;&lt;&quot;
                -  putln(l_s)
                +    </localSection>
                +    <source><code>begin
                +  putln(&quot;&lt;&quot;)
            "#]],
        );
    }

    #[test]
    fn lists_are_arguments_where_their_type_is_certain() {
        for (line, wanted) in [
            ("pA=compose(pA,fA,l_tr)", "+pA=compose(pA,fA,{0,0,5,0,0,0})"),
            ("call by(l_tr)", "+call by({0,0,5,0,0,0})"),
        ] {
            let found = done(&with_positions(&format!("l$0_tr={{0,0,5,0,0,0}}\n{line}")), ID);
            assert!(found.contains(wanted), "{found}");
        }
        for line in ["l_$0j={0,0,5,0,0,0}\nmovej(l_j,tA,mA)", "l_$0tr={0,0,5,0,0,0}\npA.trsf=l_tr*l_tr"] {
            let reason = refused(&with_positions(line), ID);
            assert!(reason.as_ref().is_some_and(|reason| reason.contains("plain value")), "{line}: {reason:?}");
        }
    }

    /// A program with data and locals for positions.
    fn with_positions(code: &str) -> String {
        format!(
            "point pA\nframe fA\ntool tA\nmdesc mA\nprogram other()\n  trsf l_tr\n  joint l_j\nbegin\n{code}\nend\nprogram by(trsf x_tr)\nbegin\nend"
        )
    }

    #[test]
    fn a_value_may_be_computed_later_if_nothing_changes_it() {
        for code in [
            "l$0_n=nA\nnB=1\nputln(l_n)",
            "l$0_n=nA\nnA=l_n+1",
            "l_m=1\nl$0_n=l_m\ndelay(1)\nputln(l_n)\nl_m=2",
            "l$0_n=clock()\nputln(l_n)",
            "l$0_n=get()\nputln(l_n)",
            "l$0_n=3\nwhile bA\n  nA=l_n\nendWhile",
            "while bA\n  l$0_n=nA\n  nB=l_n\nendWhile",
        ] {
            assert_eq!(refused(&listing(code), ID), None, "{code}");
            done(&listing(code), ID);
        }
    }

    #[test]
    fn other_variables_are_refused_with_the_reason() {
        for (code, reason) in [
            ("l$0_n=1\nl_n=2\nputln(l_n)", "at 2 places"),
            ("l$0_n=1", "never read"),
            ("l$0_n=1\ncall by(l_n)\nputln(l_n)", "at 2 places"),
            ("l$0_n=l_m=1\nputln(l_n)", "separate assignment"),
            ("l_m=l$0_n=1\nputln(l_n)", "separate assignment"),
            ("if bA\n  l$0_n=1\nendIf\nputln(l_n)", "does not always precede"),
            ("putln(l_n)\nl$0_n=1", "does not always precede"),
            ("l$0_n=nA\nnA=1\nputln(l_n)", "may change"),
            ("l$0_n=nA\ndelay(1)\nputln(l_n)", "may change"),
            ("l$0_n=nA\ncall by(l_m)\nputln(l_n)", "may change"),
            ("l$0_n=nA\nwait(bA)\nputln(l_n)", "may change"),
            ("l$0_n=get()\nnA=1\nputln(l_n)", "another time"),
            ("l$0_n=clock()\nnA=1\nputln(l_n)", "another time"),
            ("l$0_n=get()\nputln(get()+l_n)", "another time"),
            ("l$0_n=nA\nwhile bA\n  putln(l_n)\nendWhile", "loop"),
            ("l$0_n=nA\nnB=size(l_n)", "plain value"),
            ("l$0_n=nA\nnB=l_n[0]", "plain value"),
            ("for l$0_n=0 to 1\n  putln(l_n)\nendFor", "at 2 places"),
        ] {
            let found = refused(&listing(code), ID);
            assert!(found.as_ref().is_some_and(|found| found.contains(reason)), "{code}: {found:?}");
        }
    }

    #[test]
    fn the_end_of_a_cdata_section_is_not_written() {
        let code =
            "num nA[3]\nnum nB[3]\nbool bA\nprogram other()\n  num l_n\nbegin\n  l$0_n=nA[nB[0]]\n  bA=l_n>2\nend";
        assert!(refused(code, ID).is_some_and(|reason| reason.contains("CDATA")));
    }
}
