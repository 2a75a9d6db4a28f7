#[path = "@BASE@.rs"]
mod kernel;

use std::io::BufRead;

fn main() {
    let text = std::fs::read_to_string("values").unwrap();
    let mut values: Vec<f64> = text.split_whitespace().map(|word| word.parse().unwrap()).collect();
    let first = values[0];
    let mut constants = [0.0; @CONSTANTS@];
    let mut output = [0.0; @OUTPUTS@];
    kernel::preprocess(&values[@INPUTS@..], &mut constants);
    for line in std::io::stdin().lock().lines() {
        let calls: u64 = line.unwrap().trim().parse().unwrap();
        let mut sum = 0.0;
        let begin = std::time::Instant::now();
        for i in 0..calls {
            values[0] = first + 1e-7 * (i & 15) as f64;
            kernel::compute(&values[..@INPUTS@], &constants, &mut output);
            sum += output[0];
        }
        println!("{} {}", begin.elapsed().as_nanos() as f64 / calls as f64, sum);
    }
}
