//! Numbers at the edges of plots.

/// A number with at most two decimals, and none that is not needed.
pub(super) fn number(number: f64) -> String {
    let text = format!("{number:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text {
        "-0" => "0".to_owned(),
        text => text.to_owned(),
    }
}

/// Numbers from 0 to at least `most` at equal distances of 1, 2 or 5 and their tens; at most
/// six of them. `least` is the smallest distance.
pub(super) fn from_zero(most: f64, least: f64) -> Vec<f64> {
    let mut step = least;
    for factor in [2.0, 2.5, 2.0].iter().cycle() {
        if most / step <= 5.0 {
            break;
        }
        step *= factor;
    }
    let is_needed = |index: &u32| *index <= 1 || f64::from(index - 1) * step < most;
    let numbers = (0..=5).take_while(is_needed);
    numbers.map(|index| f64::from(index) * step).collect()
}

/// Powers of ten between two numbers, both of them excluded but for a first power itself.
pub(super) fn powers(least: f64, most: f64) -> Vec<f64> {
    let mut powers = Vec::new();
    let mut power = least;
    // Closer to the end than this, the two labels would touch.
    while power < 0.6 * most {
        powers.push(power);
        power *= 10.0;
    }
    powers
}

/// At most ten of some numbers, the first and the last among them, to be told at an axis.
pub(super) fn few(numbers: &[usize]) -> Vec<usize> {
    let step = numbers.len().div_ceil(10).max(1);
    let last = numbers.len().saturating_sub(1);
    let is_told = |index: usize| {
        index == last || (index.is_multiple_of(step) && index + step <= last.max(step))
    };
    let told = numbers
        .iter()
        .enumerate()
        .filter(|(index, _)| is_told(*index));
    told.map(|(_, number)| *number).collect()
}

/// Heights of labels, each close to where it belongs and `apart` from the next.
pub(super) fn spread(wanted: &[f64], apart: f64, top: f64, bottom: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    let at = |index: usize| wanted.get(index).copied().unwrap_or_default();
    order.sort_by(|&one, &other| at(one).total_cmp(&at(other)));
    let mut heights = wanted.to_vec();
    let mut next = top;
    for &index in &order {
        heights[index] = at(index).max(next);
        next = heights[index] + apart;
    }
    // Where they run out at the bottom, they move up again.
    let mut next = bottom;
    for &index in order.iter().rev() {
        heights[index] = heights[index].min(next);
        next = heights[index] - apart;
    }
    heights
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_have_few_round_numbers() {
        assert_eq!(from_zero(160.0, 1.0), [0.0, 50.0, 100.0, 150.0, 200.0]);
        assert_eq!(from_zero(3.0, 1.0), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(from_zero(0.0, 1.0), [0.0, 1.0]);
        assert_eq!(from_zero(37.2, 1.0), [0.0, 10.0, 20.0, 30.0, 40.0]);
        let told: Vec<String> = powers(0.01, 60.0).into_iter().map(number).collect();
        assert_eq!(told, ["0.01", "0.1", "1", "10"]);
        let numbers: Vec<usize> = (1..=25).collect();
        assert_eq!(few(&numbers), [1, 4, 7, 10, 13, 16, 19, 22, 25]);
        assert_eq!(few(&[5]), [5]);
        assert_eq!(few(&[]), Vec::<usize>::new());
    }

    #[test]
    fn labels_keep_apart_and_within() {
        assert_eq!(
            spread(&[10.0, 12.0, 100.0], 15.0, 0.0, 200.0),
            [10.0, 25.0, 100.0]
        );
        assert_eq!(spread(&[195.0, 190.0], 15.0, 0.0, 200.0), [200.0, 185.0]);
        assert_eq!(spread(&[], 15.0, 0.0, 200.0), Vec::<f64>::new());
    }
}
