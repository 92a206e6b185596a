//! Images without the code of the programs.

use val3_lang::memory::PartInit;
use val3_lang::types::LengthUnit;
use val3_lang::versions::Version;

use super::ListingForm;
use super::error::Result;
use super::forms::{Autoload, Flag, Listed, Name, Number, Of, Optional, Public, Quoted, Reference, choices, sequences};
use super::reader::ListingReader;
use super::values::{ArmName, BaseName, Brackets, ListedType};
use super::writer::Writer;
use crate::{
    DataDef, FatherLink, Image, Import, ImportKind, LibraryDef, LinkInit, LinkTarget, ProgramRef, plan_passes,
};

sequences! {
    DataDef { public: Flag<Public>, name: Name, init: PartInit };
    LinkInit { data: Number, path: Listed<(Number, Number)>, value: Number, link: Number, target: LinkTarget };
    FatherLink { name: Name, at: Quoted, fields: Listed<(Name, Quoted)>, library: Optional<Of, Name> };
    LibraryDef { alias: Name, path: Quoted, autoload: Flag<Autoload> };
    Import { library: Library, name: Name, kind: ImportKind };
}

choices! {
    LinkTarget, "`port`, `father` or `signal`" {
        "port" Port(base: BaseName, path: Quoted),
        "father" Father(reference: FatherLink),
        "signal" Signal(reference: FatherLink),
    }
    ImportKind, "`data`, `program` or `missing`" {
        "data" Data(kind: ListedType, container: Brackets),
        "program" Program(params: Listed<(ListedType, Brackets, Flag<Reference>)>),
        "missing" Missing,
    }
}

/// A library identifier.
pub(super) struct Library;

impl ListingForm for Library {
    type Value = u16;

    fn write(value: &u16, to: &mut Writer<'_>) {
        let image = to.image;
        to.item(image.libraries.iter().map(|library| library.alias.as_str()), (*value).into());
    }

    fn read(from: &mut ListingReader<'_>) -> Result<u16> {
        from.item("library", |from| from.image.libraries.iter().map(|library| library.alias.clone()).collect())
    }
}

impl<'i> Writer<'i> {
    pub(super) fn image(&mut self) {
        let image = self.image;
        self.each::<(Name, Quoted)>("image", &[(image.name.clone(), image.path.clone())]);
        self.put(&format!("version {}\n", image.version));
        if image.unit == LengthUnit::Inch {
            self.put("unit inch\n");
        }
        self.each::<ArmName>("arm", image.arm.as_slice());
        self.each::<Number>("stack", &[image.stack_size]);
        if image.sees_private_items {
            self.put("sees private items\n");
        }
        self.each::<Quoted>("file", &image.files);
        let items = self.aside(|to| to.items(image));
        let types = std::mem::take(&mut self.types);
        self.put(&types);
        self.put(&items);
    }

    fn items(&mut self, image: &'i Image) {
        self.each::<DataDef>("data", &image.data);
        self.each::<LinkInit>("link", &image.links);
        self.each::<LibraryDef>("library", &image.libraries);
        self.each::<Import>("import", &image.imports);
        for program in &image.programs {
            self.program(program);
        }
    }

    /// Writes one line for each item, which begins with a word.
    pub(super) fn each<F: ListingForm>(&mut self, word: &str, items: &[F::Value]) {
        for item in items {
            self.put(word);
            self.part(|to| F::write(item, to));
            self.put("\n");
        }
    }
}

impl ListingReader<'_> {
    pub(super) fn image(mut self) -> Result<Image> {
        while !self.is_at_end() {
            match self.take() {
                "image" => (self.image.name, self.image.path) = <(Name, Quoted)>::read(&mut self)?,
                "version" => self.image.version = self.version()?,
                "unit" => {
                    self.expect("inch")?;
                    self.image.unit = LengthUnit::Inch;
                }
                "arm" => self.image.arm = Some(ArmName::read(&mut self)?),
                "stack" => self.image.stack_size = self.number()?,
                "sees" => {
                    self.expect("private")?;
                    self.expect("items")?;
                    self.image.sees_private_items = true;
                }
                "file" => self.add::<Quoted>(|image| &mut image.files)?,
                "type" => self.user_type()?,
                "data" => self.add::<DataDef>(|image| &mut image.data)?,
                "link" => self.add::<LinkInit>(|image| &mut image.links)?,
                "library" => self.add::<LibraryDef>(|image| &mut image.libraries)?,
                "import" => self.add::<Import>(|image| &mut image.imports)?,
                "program" => self.program()?,
                token => return self.fail(&format!("`{token}` begins no declaration")),
            }
        }
        self.connect()?;
        plan_passes(&mut self.image.programs);
        self.image.number_counters();
        Ok(self.image)
    }

    fn add<F: ListingForm>(&mut self, list: fn(&mut Image) -> &mut Vec<F::Value>) -> Result<()> {
        let item = F::read(self)?;
        list(&mut self.image).push(item);
        Ok(())
    }

    fn version(&mut self) -> Result<Version> {
        let token = self.take();
        Version::parse(token).map_or_else(|| self.fail(&format!("`{token}` is no version")), Ok)
    }

    /// Resolves the program names in calls to numbers.
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
