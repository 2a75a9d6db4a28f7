// A library outside of the roots: a header, and code that is compiled elsewhere.
#ifdef __cplusplus
extern "C" {
#endif
double sensor_gain(void);
int sensor_count(int channel);
double sensor_scaled(double x);
#ifdef __cplusplus
}

namespace sensor {
inline double offset = 0.5;
inline double shifted() { return offset * 2; }
inline double half() { return 0.5; }
struct Device {
  double bias() const;
};
} // namespace sensor
#endif
