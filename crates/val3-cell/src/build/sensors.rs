//! Sensors of a cell file.

use val3_collision::Shape;
use val3_geometry::{IsometryMatrix3, Vector3};

use crate::allowed::AllNames;
use crate::build::CellMaker;
use crate::carriers::{Carried, CarriedKeys};
use crate::error::CellError;
use crate::file::{BeamKeys, SensorEntry};
use crate::poses::{check_size, triple};
use crate::sensor::{Detects, Sensor, SensorForm};
use crate::solids::{Solid, SolidMaker, solid, without_shape};
use crate::surroundings::SignalClass;

/// Radius of a beam, in mm.
const BEAM: f64 = 0.5;

/// Longest accepted delay, in seconds.
const LONGEST_DELAY: f64 = 3600.0;

/// Shape of a sensor, its pose, and its form for drawings.
type SensorShape = (Shape, IsometryMatrix3<f64>, SensorForm);

impl CellMaker<'_> {
    /// Builds the sensors. `bodies` are the names of all things and parts in the file.
    pub(super) fn sensors(
        &mut self,
        entries: &[SensorEntry],
        bodies: &[String],
        axes: usize,
    ) -> Result<Vec<Sensor>, CellError> {
        let names = AllNames::new(bodies, axes);
        let mut sensors = Vec::new();
        for (index, entry) in entries.iter().enumerate() {
            match self.sensor(entry, &format!("sensor[{index}]"), &names)? {
                Some(sensor) => sensors.push(sensor),
                None => self.missing.push(entry.name.clone()),
            }
        }
        Ok(sensors)
    }

    /// Builds a sensor; `None` if the application does not have the frame or the input.
    fn sensor(&mut self, entry: &SensorEntry, key: &str, names: &AllNames) -> Result<Option<Sensor>, CellError> {
        let SensorEntry { name, carrier, io, not, sees: patterns, delay, .. } = entry;
        if !(0.0..=LONGEST_DELAY).contains(delay) {
            let help = format!("write seconds from 0 to {LONGEST_DELAY}");
            return Err(CellError::new(format!("{key}.delay"), format!("{delay} is no delay"), help));
        }
        let (shape, own, form) = self.sensor_shape(entry, key)?;
        let detects = match patterns {
            None => Detects::Parts,
            Some(patterns) => {
                let matchers = patterns.iter().map(|name| names.matcher(name, &format!("{key}.sees")));
                Detects::Named(matchers.collect::<Result<_, _>>()?)
            }
        };
        let keys = CarriedKeys { carrier: carrier.as_deref().unwrap_or("world"), at: &[], key };
        let Some(Carried { carrier, pose }) = self.carriers.of(keys, self.surroundings)? else { return Ok(None) };
        if let Some(path) = io {
            match self.input(path, &format!("{key}.io"))? {
                None => return Ok(None),
                Some(SignalClass::Analog) => {
                    let help = "name a digital input";
                    return Err(CellError::new(format!("{key}.io"), format!("`{path}` is analog"), help));
                }
                Some(SignalClass::Digital | SignalClass::Unknown) => {}
            }
        }
        let (name, io) = (name.clone(), io.clone());
        let pose = pose * own;
        Ok(Some(Sensor { name, io, is_inverted: *not, delay: *delay, carrier, shape, pose, detects, form }))
    }

    fn sensor_shape(&mut self, entry: &SensorEntry, key: &str) -> Result<SensorShape, CellError> {
        match (&entry.beam, &entry.zone) {
            (Some(_), Some(_)) => {
                let message = format!("`{}` has a beam and a zone", entry.name);
                Err(CellError::new(format!("{key}.zone"), message, "describe two sensors"))
            }
            (None, None) => {
                let help = "add `beam = { from = [0, -200, 50], to = [0, 200, 50] }`, or a `zone` with a shape";
                Err(CellError::new(key, format!("`{}` has no beam and no zone", entry.name), help))
            }
            (Some(BeamKeys { from, to }), None) => {
                let from = triple(from, &format!("{key}.beam.from"))?;
                let to = triple(to, &format!("{key}.beam.to"))?;
                from.iter().chain(&to).try_for_each(|number| check_size(*number, &format!("{key}.beam")))?;
                if from == to {
                    let message = format!("the beam of `{}` begins and ends at the same point", entry.name);
                    return Err(CellError::new(format!("{key}.beam"), message, "write two different points"));
                }
                let shape = Shape::capsule(Vector3::from(from), Vector3::from(to), BEAM)
                    .map_err(|error| CellError::new(format!("{key}.beam"), format!("it is no beam: {error}"), ""))?;
                Ok((shape, IsometryMatrix3::identity(), SensorForm::Beam([from, to])))
            }
            (None, Some(zone)) => {
                let key = format!("{key}.zone");
                let mut maker = SolidMaker { surroundings: &mut *self.surroundings, is_carried: true };
                let made = solid(&zone.shape, &zone.at, &key, &mut maker)?;
                let Solid { shape, pose, form } = made.ok_or_else(|| without_shape(&key, "this zone"))?;
                Ok((shape, pose, SensorForm::Zone(form)))
            }
        }
    }
}
