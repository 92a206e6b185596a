//! Locations of parameters and locals in the frame (2.6).

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_analysis::body::{Body, Expr, ExprId, StmtKind};
use val3_analysis::infer::Inference;
use val3_analysis::items::program::{Header, LocalDecl};
use val3_analysis::items::project::{SignatureParam as Declared, resolve_type, signature};
use val3_analysis::ty::Base;
use val3_bytecode::{FrameVariable, ProgramParam, Storage};
use val3_lang::instruction::ArgumentForm;
use val3_lang::memory::ContainerShape as Form;
use val3_lang::types::Container;

use crate::data::shape;
use crate::emitter::Emitter;
use crate::error::{CompileLimit, Result, there};

/// Assigns locations to the parameters and locals of a program.
pub(crate) struct Declarations<'a, 'u, 'db> {
    pub(crate) out: &'a mut Emitter<'u, 'db>,
    pub(crate) header: &'db Header,
    pub(crate) body: &'db Body,
    pub(crate) types: &'db Inference,
}

impl Declarations<'_, '_, '_> {
    /// Declares all variables. Returns the parameters, and the names and locations of all variables for debuggers.
    pub(crate) fn declare(&mut self, params: &[Declared]) -> Result<(Vec<ProgramParam>, Vec<FrameVariable>)> {
        let params = self.params(params)?;
        self.locals()?;
        let variables = self.variables(&params)?;
        Ok((params, variables))
    }

    /// Assigns locations to the parameters, in order. A parameter with a missing type needs none, because a caller
    /// stops before the call.
    fn params(&mut self, params: &[Declared]) -> Result<Vec<ProgramParam>> {
        params.iter().filter_map(|param| there(self.param(param)).transpose()).collect()
    }

    fn param(&mut self, param: &Declared) -> Result<ProgramParam> {
        let kind = self.out.kind(param.base)?;
        let storage = match param.container {
            Container::Element if param.by_reference => Storage::Place(self.out.frame_mut().lasting_place()?),
            Container::Element if kind.base_type().is_some() => Storage::Value(self.out.frame_mut().lasting(&kind)?),
            Container::Element => Storage::Part(self.out.frame_mut().part(kind.clone(), Form::ELEMENT)?),
            Container::Array { .. } | Container::Collection => Storage::View(self.out.frame_mut().lasting_view()?),
        };
        self.out.frame_mut().declare(param.name.clone(), storage);
        Ok(ProgramParam { name: param.name.to_string(), kind, container: param.container, storage })
    }

    /// Assigns locations to the locals. A single value of a built-in type is stored in lanes, unless the code uses it
    /// as an array.
    fn locals(&mut self) -> Result<()> {
        let arrays = self.used_as_arrays();
        self.header.locals.iter().try_for_each(|local| there(self.local(local, &arrays)).map(drop))
    }

    fn local(&mut self, local: &LocalDecl, arrays: &FxHashSet<SmolStr>) -> Result<()> {
        // A parameter with the same name hides the local.
        if self.out.frame().find(&local.name).is_some() {
            return Ok(());
        }
        let base = resolve_type(&self.out.unit().items.types, &local.type_name).unwrap_or(Base::Unknown);
        let kind = self.out.kind(base)?;
        let in_lanes = local.sizes == [1] && kind.base_type().is_some() && !arrays.contains(&local.name);
        let storage = if in_lanes {
            Storage::Value(self.out.frame_mut().lasting(&kind)?)
        } else {
            Storage::Part(self.out.frame_mut().part(kind, shape(local.container, &local.sizes))?)
        };
        self.out.frame_mut().declare(local.name.clone(), storage);
        Ok(())
    }

    /// Returns the names that the code uses with an index or passes as a container.
    fn used_as_arrays(&self) -> FxHashSet<SmolStr> {
        let mut names = FxHashSet::default();
        for (id, expr, _) in self.body.exprs() {
            match expr {
                Expr::Index(of, _) => names.extend(self.name(*of)),
                Expr::Call(_, args) => {
                    let shapes = self.instruction_shapes(id);
                    let containers = args.iter().zip(shapes).filter(|(_, shape)| is_container(*shape));
                    names.extend(containers.filter_map(|(id, _)| self.name(*id)));
                }
                _ => {}
            }
        }
        for call in self.program_calls() {
            let Expr::Call(_, args) = self.body.expr(call) else { continue };
            let shapes = self.program_shapes(call);
            let containers = args.iter().zip(shapes).filter(|(_, shape)| is_container(*shape));
            names.extend(containers.filter_map(|(id, _)| self.name(*id)));
        }
        names
    }

    fn name(&self, id: ExprId) -> Option<SmolStr> {
        match self.body.expr(id) {
            Expr::Name(name) => Some(name.clone()),
            _ => None,
        }
    }

    fn instruction_shapes(&self, call: ExprId) -> Vec<ArgumentForm> {
        let known = self.types.call(call).and_then(|call| call.form);
        let add_on = self.types.add_on_call(call);
        let known = known.iter().flat_map(|form| form.params).map(|param| param.shape);
        known.chain(add_on.iter().flat_map(|call| &call.form.params).map(|param| param.shape)).collect()
    }

    fn program_calls(&self) -> Vec<ExprId> {
        let calls = self.body.stmts().into_iter().filter_map(|stmt| match &stmt.kind {
            StmtKind::Call(call) => Some(*call),
            StmtKind::TaskCreate { arguments, .. } => arguments.last().copied(),
            _ => None,
        });
        calls.collect()
    }

    fn program_shapes(&self, call: ExprId) -> Vec<ArgumentForm> {
        let Expr::Call(callee, _) = self.body.expr(call) else { return Vec::new() };
        let Some((project, file)) = self.out.unit().callee(self.body.expr(*callee)) else { return Vec::new() };
        signature(self.out.unit().db, project, file).params.iter().map(|param| param.shape()).collect()
    }

    /// Returns the names and locations of variables for debuggers.
    fn variables(&mut self, params: &[ProgramParam]) -> Result<Vec<FrameVariable>> {
        let mut variables = Vec::new();
        for param in params {
            let storage = self.out.frame().find(&param.name).ok_or(CompileLimit::Unclear)?;
            let (kind, container) = (param.kind.clone(), param.container);
            variables.push(FrameVariable { name: param.name.clone(), kind, container, storage });
        }
        for local in self.header.locals.iter().filter(|local| params.iter().all(|param| param.name != local.name)) {
            // A local with a missing type has no location.
            let Some(storage) = self.out.frame().find(&local.name) else { continue };
            let base = resolve_type(&self.out.unit().items.types, &local.type_name).unwrap_or(Base::Unknown);
            let (kind, name) = (self.out.kind(base)?, local.name.to_string());
            let container = if local.sizes == [1] { Container::Element } else { local.container };
            variables.push(FrameVariable { name, kind, container, storage });
        }
        Ok(variables)
    }
}

fn is_container(shape: ArgumentForm) -> bool {
    !matches!(shape, ArgumentForm::Value | ArgumentForm::Reference)
}
