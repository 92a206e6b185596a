//! Images: everything apart from the code of the programs.

use val3_lang::memory::PartInit;
use val3_lang::types::LengthUnit;
use val3_lang::versions::Version;

use super::reader::Reader;
use super::values::{ArmType, Declared, read_type};
use super::writer::{PUBLIC, Writer};
use super::{Form, Result};
use crate::{
    DataDef, FatherLink, Image, Import, ImportKind, LibraryDef, LinkInit, LinkTarget, ProgramRef, plan_passes,
};

impl<'i> Writer<'i> {
    pub(super) fn image(&mut self) {
        let image = self.image;
        self.put("image ");
        self.name(&image.name);
        self.put(&format!(" {:?}\nversion {}\n", image.path, image.version));
        if image.unit == LengthUnit::Inch {
            self.put("unit inch\n");
        }
        self.put(&format!("stack {}\n", image.stack_size));
        for file in &image.files {
            self.put(&format!("file {file:?}\n"));
        }
        let items = self.aside(|to| to.items(image));
        let types = std::mem::take(&mut self.types);
        self.put(&types);
        self.put(&items);
    }

    fn items(&mut self, image: &'i Image) {
        for data in &image.data {
            self.put(if data.public { "data public " } else { "data " });
            self.name(&data.name);
            self.put(" ");
            PartInit::write(&data.init, self);
            self.put("\n");
        }
        self.each("link ", &image.links, LinkInit::write);
        self.each("library ", &image.libraries, LibraryDef::write);
        self.each("import ", &image.imports, Import::write);
        for program in &image.programs {
            self.program(program);
        }
    }

    fn each<T>(&mut self, word: &str, items: &[T], write: impl Fn(&T, &mut Self)) {
        for item in items {
            self.put(word);
            write(item, self);
            self.put("\n");
        }
    }

    /// A library identifier.
    pub(super) fn library(&mut self, number: u16) {
        let image = self.image;
        self.item(image.libraries.iter().map(|library| library.alias.as_str()), number.into());
    }
}

impl Reader<'_> {
    pub(super) fn image(mut self) -> Result<Image> {
        while !self.is_at_end() {
            match self.take() {
                "image" => {
                    self.image.name = self.name()?;
                    self.image.path = self.quoted()?;
                }
                "version" => self.image.version = self.version()?,
                "unit" => {
                    self.expect("inch")?;
                    self.image.unit = LengthUnit::Inch;
                }
                "stack" => self.image.stack_size = self.number()?,
                "file" => {
                    let file = self.quoted()?;
                    self.image.files.push(file);
                }
                "type" => read_type(&mut self)?,
                "data" => self.data()?,
                "link" => {
                    let link = LinkInit::read(&mut self)?;
                    self.image.links.push(link);
                }
                "library" => {
                    let library = LibraryDef::read(&mut self)?;
                    self.image.libraries.push(library);
                }
                "import" => {
                    let import = Import::read(&mut self)?;
                    self.image.imports.push(import);
                }
                "program" => self.program()?,
                token => return self.fail(&format!("`{token}` begins no declaration")),
            }
        }
        self.connect()?;
        plan_passes(&mut self.image.programs);
        Ok(self.image)
    }

    fn version(&mut self) -> Result<Version> {
        let token = self.take();
        Version::parse(token).map_or_else(|| self.fail(&format!("`{token}` is no version")), Ok)
    }

    fn data(&mut self) -> Result<()> {
        let public = self.accept(PUBLIC);
        let data = DataDef { public, name: self.name()?, init: PartInit::read(self)? };
        self.image.data.push(data);
        Ok(())
    }

    /// A library identifier.
    pub(super) fn library(&mut self) -> Result<u16> {
        let aliases =
            |from: &Self| from.image.libraries.iter().map(|library| library.alias.clone()).collect::<Vec<_>>();
        self.item("library", aliases).map(|number| u16::try_from(number).unwrap_or(u16::MAX))
    }

    /// Gives calls the numbers of the programs that they name.
    fn connect(&mut self) -> Result<()> {
        let mut numbers = Vec::new();
        for callee in &self.callees {
            let number = callee.name.parse().ok().or_else(|| self.image.program(&callee.name));
            match number.filter(|number| usize::from(*number) < self.image.programs.len()) {
                Some(number) => numbers.push(number),
                None => return self.fail_at(callee.used, &format!("there is no program `{}`", callee.name)),
            }
        }
        for program in &mut self.image.programs {
            let of_tasks = program.tasks.iter_mut().map(|task| &mut task.call);
            for call in program.calls.iter_mut().chain(of_tasks) {
                if let ProgramRef::Own(number) = &mut call.program {
                    *number = numbers.get(usize::from(*number)).copied().unwrap_or(*number);
                }
            }
        }
        Ok(())
    }
}

impl Form for LibraryDef {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        to.name(&value.alias);
        to.put(&format!(" {:?}{}", value.path, if value.autoload { " autoload" } else { "" }));
    }

    fn read(from: &mut Reader<'_>) -> Result<Self> {
        Ok(Self { alias: from.name()?, path: from.quoted()?, autoload: from.accept("autoload") })
    }
}

/// `part nX num[]`, `part tell (num, string[]&)`, `part gone missing`
impl Form for Import {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        to.library(value.library);
        to.put(" ");
        to.name(&value.name);
        to.put(" ");
        match &value.kind {
            ImportKind::Data(kind, container) => Declared::write(&(kind.clone(), *container), to),
            ImportKind::Program(params) => {
                to.put("(");
                to.list(params, ", ", |(kind, container, by_reference), to| {
                    Declared::write(&(kind.clone(), *container), to);
                    to.put(if *by_reference { "&" } else { "" });
                });
                to.put(")");
            }
            ImportKind::Missing => to.put("missing"),
        }
    }

    fn read(from: &mut Reader<'_>) -> Result<Self> {
        let (library, name) = (from.library()?, from.name()?);
        let kind = if from.accept("missing") {
            ImportKind::Missing
        } else if from.accept("(") {
            ImportKind::Program(from.list((",", ")"), |from| {
                let (kind, container) = Declared::read(from)?;
                Ok((kind, container, from.accept("&")))
            })?)
        } else {
            let (kind, container) = Declared::read(from)?;
            ImportKind::Data(kind, container)
        };
        Ok(Self { library, name, kind })
    }
}

/// `0 [2 1] 3 1 -> port dio "BasicIO-1\\%I0"`: data, the way to the innermost container, value and link there, target.
impl Form for LinkInit {
    type Value = Self;

    fn write(value: &Self, to: &mut Writer<'_>) {
        to.put(&format!("{} [", value.data));
        to.list(&value.path, ", ", |(value, field), to| to.put(&format!("{value} {field}")));
        to.put(&format!("] {} {} -> ", value.value, value.link));
        match &value.target {
            LinkTarget::Port(base, path) => to.put(&format!("port {} {path:?}", base.name())),
            LinkTarget::Father(father) => write_reference("father ", father, to),
            LinkTarget::Signal(signal) => write_reference("signal ", signal, to),
        }
    }

    fn read(from: &mut Reader<'_>) -> Result<Self> {
        let data = from.number()?;
        from.expect("[")?;
        let path = from.list((",", "]"), |from| Ok((from.number()?, from.number()?)))?;
        let (value, link) = (from.number()?, from.number()?);
        from.expect("->")?;
        let target = match from.peek() {
            "port" => {
                from.take();
                LinkTarget::Port(ArmType::read(from)?.0, from.quoted()?)
            }
            "father" => LinkTarget::Father(read_reference(from)?),
            "signal" => LinkTarget::Signal(read_reference(from)?),
            _ => return from.unexpected("`port`, `father` or `signal`"),
        };
        Ok(Self { data, path, value, link, target })
    }
}

/// `father part:fTray "0" / fIn "1,2"`
fn write_reference(word: &str, reference: &FatherLink, to: &mut Writer<'_>) {
    to.put(word);
    if let Some(library) = &reference.library {
        to.name(library);
        to.put(":");
    }
    to.name(&reference.name);
    to.put(&format!(" {:?}", reference.at));
    for (name, at) in &reference.fields {
        to.put(" / ");
        to.name(name);
        to.put(&format!(" {at:?}"));
    }
}

fn read_reference(from: &mut Reader<'_>) -> Result<FatherLink> {
    from.take();
    let first = from.name()?;
    let (library, name) = if from.accept(":") { (Some(first), from.name()?) } else { (None, first) };
    let at = from.quoted()?;
    let mut fields = Vec::new();
    while from.accept("/") {
        fields.push((from.name()?, from.quoted()?));
    }
    Ok(FatherLink { library, name, at, fields })
}
