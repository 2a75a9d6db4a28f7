package main

import (
    "bufio"
    "fmt"
    "os"
    "strconv"
    "strings"
    "time"
)

func main() {
    text, _ := os.ReadFile("values")
    var values []float64
    for _, word := range strings.Fields(string(text)) {
        value, _ := strconv.ParseFloat(word, 64)
        values = append(values, value)
    }
    first := values[0]
    constants := make([]float64, @CONSTANTS@)
    output := make([]float64, @OUTPUTS@)
    Preprocess(values[@INPUTS@:], constants)
    requests := bufio.NewScanner(os.Stdin)
    for requests.Scan() {
        calls, _ := strconv.Atoi(strings.TrimSpace(requests.Text()))
        sum := 0.0
        begin := time.Now()
        for i := 0; i < calls; i++ {
            values[0] = first + 1e-7*float64(i&15)
            Compute(values[:@INPUTS@], constants, output)
            sum += output[0]
        }
        fmt.Println(float64(time.Since(begin).Nanoseconds())/float64(calls), sum)
    }
}
