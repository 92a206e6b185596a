//! How far each axis of the arm may go (9.2.3).

/// Lowest and highest position of six axes, in degrees.
type Axes = [(f64, f64); 6];

/// The limits of the axes that turn about the forearm and the flange: 270 degrees each way.
const TURNS: (f64, f64) = both(270.0);

/// Six-axis arms by their model, without the separators of its parts. Data sheets and public models of the arms agree on
/// these numbers; those of the TX2-140 are taken over from the TX90.
#[rustfmt::skip]
static MODELS: [(&str, Axes); 23] = [
    ("tx40", [both(180.0), both(125.0), both(138.0), TURNS, (-120.0, 133.5), TURNS]),
    ("tx60", [both(180.0), both(127.5), both(142.5), TURNS, (-122.5, 132.5), TURNS]),
    ("tx60l", [both(180.0), both(127.5), both(152.5), TURNS, (-122.5, 132.5), TURNS]),
    ("tx90", TX90),
    ("tx90l", TX90),
    ("tx90xl", TX90),
    ("tx200", TX200),
    ("tx200l", TX200),
    ("tx240", [both(180.0), both(125.0), both(138.0), both(190.0), (-120.0, 133.5), TURNS]),
    ("tx260", [both(180.0), both(127.5), both(142.5), TURNS, (-121.0, 132.5), TURNS]),
    ("tx260l", [both(180.0), both(127.5), both(152.5), TURNS, (-121.0, 132.5), TURNS]),
    ("tx290", TX90),
    ("tx290l", TX90),
    ("tx290xl", TX90),
    ("tx2140", TX90),
    ("tx2160", [both(180.0), both(137.5), (-160.0, 165.0), TURNS, (-110.0, 135.0), TURNS]),
    ("tx2160l", [both(180.0), both(137.5), both(160.0), TURNS, (-110.0, 135.0), TURNS]),
    ("rx160", RX160),
    ("rx160l", RX160),
    ("rx90", RX90),
    ("rx90l", RX90),
    ("rx170", RX170),
    ("rx170l", RX170),
];

const TX90: Axes = [both(180.0), (-130.0, 147.5), both(145.0), TURNS, (-115.0, 140.0), TURNS];
const TX200: Axes = [both(180.0), both(120.0), (-140.0, 145.0), TURNS, both(120.0), TURNS];
const RX90: Axes = [both(160.0), both(137.5), both(142.5), TURNS, (-105.0, 120.0), TURNS];
const RX160: Axes = [both(160.0), both(137.5), both(150.0), TURNS, (-105.0, 120.0), TURNS];
const RX170: Axes = [both(180.0), both(120.0), both(145.0), TURNS, (-110.0, 130.0), TURNS];

/// The same limit in both directions.
const fn both(limit: f64) -> (f64, f64) {
    (-limit, limit)
}

/// The software limits of an arm, in degrees; in millimetres for linear axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointLimits {
    axes: Axes,
}

impl JointLimits {
    /// Nothing is known of the arm: every position is in range.
    pub const NONE: Self = Self { axes: [both(f64::INFINITY); 6] };

    /// The limits of a model as `arm.cfx` names it: `tx90l-S1`, `tx2_60l`. Those of other models are not known.
    #[must_use]
    pub fn of_model(model: &str) -> Self {
        let model = model.trim().to_ascii_lowercase();
        let name = model.rsplit_once("-s").map_or(model.as_str(), |(name, _)| name).replace(['-', '_', ' '], "");
        let known = MODELS.iter().find(|(known, _)| *known == name);
        known.map_or(Self::NONE, |(_, axes)| Self { axes: *axes })
    }

    /// Takes over lower limits that are stricter, axis by axis.
    pub fn raise(&mut self, lowest: impl IntoIterator<Item = f64>) {
        self.axes.iter_mut().zip(lowest).for_each(|((low, _), lowest)| *low = low.max(lowest));
    }

    /// Takes over upper limits that are stricter, axis by axis.
    pub fn lower(&mut self, highest: impl IntoIterator<Item = f64>) {
        self.axes.iter_mut().zip(highest).for_each(|((_, high), highest)| *high = high.min(highest));
    }

    /// Every axis is within its limits.
    #[must_use]
    pub fn contain(&self, joint: [f64; 6]) -> bool {
        self.axes.iter().zip(joint).all(|((low, high), position)| (*low..=*high).contains(&position))
    }
}

impl Default for JointLimits {
    fn default() -> Self {
        Self::NONE
    }
}

#[cfg(test)]
mod tests {
    use super::JointLimits;

    #[test]
    fn models_in_every_spelling() {
        let within = |model, j5| JointLimits::of_model(model).contain([0.0, 0.0, 0.0, 0.0, j5, 0.0]);
        for model in ["tx90l-S1", "TX90L", "tx90-S1", "tx2_90xl-S3", "tx2-90"] {
            assert!(within(model, 140.0) && within(model, -115.0), "{model}");
            assert!(!within(model, 140.1) && !within(model, -115.1) && !within(model, f64::NAN), "{model}");
        }
        assert!(within("tx2-60l", -121.0) && !within("tx2-60l", -121.5) && within("tx60l", -121.5));
    }

    #[test]
    fn an_arm_that_is_not_known_has_the_limits_of_its_file() {
        let mut limits = JointLimits::of_model("ts2_60-S1");
        assert!(limits.contain([1e6; 6]));
        limits.raise([-10.0, 0.1]);
        limits.lower([20.0, 9_999_999.0]);
        assert!(limits.contain([20.0, 0.1, 1e6, 0.0, 0.0, 0.0]));
        assert!(!limits.contain([20.1, 0.1, 0.0, 0.0, 0.0, 0.0]) && !limits.contain([0.0; 6]));
    }

    #[test]
    fn a_file_only_narrows_what_the_model_allows() {
        let mut limits = JointLimits::of_model("tx40");
        limits.raise([-500.0]);
        limits.lower([90.0]);
        assert!(limits.contain([-180.0, 0.0, 0.0, 0.0, 0.0, 0.0]));
        assert!(!limits.contain([-180.1, 0.0, 0.0, 0.0, 0.0, 0.0]) && !limits.contain([90.1, 0.0, 0.0, 0.0, 0.0, 0.0]));
    }
}
