using System.Numerics;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>
/// The weights of all ways to make a path, as the partial sums of its two ends give them, against the densities of whole paths (Veach 1997, section 10.2;
/// merges as Georgiev et al. 2012 count them).
/// Covers `SubpathSumsW` and `PathWeights`.
/// </summary>
public sealed class PathWeightsTests
{
    private static readonly ShadingGroup s_media = new(new MediumMaterial(new([])), null, -1, isInstanced: false);

    private const int CameraPaths = 500;

    [Theory]
    [InlineData(2, false, 1)]
    [InlineData(2, true, 2)]
    [InlineData(3, true, 1)]
    [InlineData(4, false, 2)]
    [InlineData(4, true, 2)]
    [InlineData(6, true, 2)]
    public void Every_way_has_its_share_of_the_powers_of_all_densities(int edges, bool merges, int perLightPath)
    {
        Random random = new(TestSettings.Seed + edges);
        PathWeights weights = new(CameraPaths, perLightPath, merges ? 0.03f : 0);
        for (int i = 0; i < 40; i++)
        {
            MadeUpPath path = new(edges, random, weights);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                Dictionary<string, double> powers = path.Densities(lane).ToDictionary(d => d.Key, d => d.Value * d.Value);
                double sum = powers.Values.Sum();
                foreach ((string way, FloatW weight) in path.Weights().Where(w => powers.ContainsKey(w.Key)))
                {
                    double expected = powers[way] / sum;
                    Assert.True(Math.Abs(weight[lane] - expected) < 1e-6 + (1e-3 * expected), $"{way} of {edges} edges has the weight {weight[lane]}, not {expected}");
                }

                Assert.Equal(powers.Count, path.Weights().Count(w => powers.ContainsKey(w.Key)));
            }
        }
    }

    // Vertices from the light, number 0, to the camera, with random densities at each, in packets; some are in media, some scatter into single directions.
    private sealed class MadeUpPath
    {
        private readonly int _last;
        private readonly PathWeights _weights;
        private readonly bool[] _isInMedium;
        private readonly MaskW[] _delta;

        // Factors of what a vertex meets towards the one before, and the next; densities of the next one for light, and of the one before for the camera.
        private readonly FloatW[] _before, _after, _forth, _back;

        // Of the edge to a vertex from the one before: squared length, and how likely media let paths through.
        private readonly FloatW[] _distance2, _passing;
        private readonly FloatW _point, _direction, _asked, _camera;

        public MadeUpPath(int edges, Random random, PathWeights weights)
        {
            (_last, _weights) = (edges, weights);
            FloatW Any(double least, double most)
            {
                float[] lanes = [.. Enumerable.Range(0, FloatW.Count).Select(_ => (float)(least * Math.Pow(most / least, random.NextDouble())))];
                return new(new Vector<float>(lanes));
            }

            FloatW[] All(double least, double most) => [.. Enumerable.Range(0, edges + 1).Select(_ => Any(least, most))];
            _isInMedium = [.. Enumerable.Range(0, edges + 1).Select(_ => random.Next(4) == 0)];
            _before = All(0.1, 1);
            _after = [.. All(0.1, 1).Select((a, i) => _isInMedium[i] ? _before[i] : a)];
            (_forth, _back, _distance2, _passing) = (All(0.05, 3), All(0.05, 3), All(0.2, 4), All(0.2, 1));

            // Single directions are as likely for both.
            _delta = [.. Enumerable.Range(0, edges + 1).Select(i => i > 0 && i < edges && !_isInMedium[i] ? Any(0.5, 2) > 1.5f : MaskW.None)];
            (_forth, _back) = ([.. _forth.Select((f, i) => _delta[i].Select(1f, f))], [.. _back.Select((b, i) => _delta[i].Select(1f, b))]);
            (_point, _direction, _asked, _camera) = (Any(0.1, 1), Any(0.05, 1), Any(0.05, 3), Any(50, 500));
        }

        /// <summary>The densities of a lane's path by all ways that can make it, for each camera path.</summary>
        public Dictionary<string, double> Densities(int lane)
        {
            Dictionary<string, double> densities = [];
            double perCameraPath = 1 / _weights.PerLightPath;
            double cosine = _after[0][lane];
            densities["met"] = Camera(0, lane);
            if (!Has(1, lane))
            {
                densities["asked"] = _asked[lane] * cosine / _distance2[1][lane] * Camera(1, lane);
            }

            for (int end = 1; end + 1 < _last; end++)
            {
                if (!Has(end, lane) && !Has(end + 1, lane))
                {
                    densities[$"connected {end}"] = perCameraPath * Light(end, lane) * Camera(end + 1, lane);
                }
            }

            if (!Has(_last - 1, lane))
            {
                densities["seen by the camera"] = perCameraPath * CameraPaths * Light(_last - 1, lane);
            }

            for (int at = 1; at < _last && _weights.Merge > 0; at++)
            {
                if (!Has(at, lane) && !_isInMedium[at])
                {
                    densities[$"merged {at}"] = perCameraPath * _weights.Merge * Light(at, lane) * Camera(at, lane);
                }
            }

            return densities;
        }

        /// <summary>The weights by partial sums, as the integrator computes them.</summary>
        public Dictionary<string, FloatW> Weights()
        {
            SubpathSumsW[] lit = LightSums();
            SubpathSumsW[] seen = CameraSums();
            FloatW emission = _point * _direction;
            FloatW cosine = _after[0];
            Dictionary<string, FloatW> weights = [];
            FloatW askedArea = _asked * cosine / _distance2[1];
            weights["met"] = Share(FloatW.MultiplyAdd(PathWeights.Power(askedArea), seen[0].Vcm, PathWeights.Power(emission / _weights.PerLightPath) * seen[0].Vc));
            FloatW towards = emission * _before[1] / (_asked * cosine * _weights.PerLightPath);
            FloatW others = PathWeights.Power(_back[1] / _asked) + (PathWeights.Power(towards) * seen[1].Connected(_forth[1], At(1)));
            weights["asked"] = Share(others * PathWeights.Power(_passing[1]));
            for (int end = 1; end + 1 < _last; end++)
            {
                FloatW fromLight = PathWeights.Power(_back[end + 1] * _after[end] / _distance2[end + 1]) * lit[end].Connected(_back[end], At(end));
                FloatW fromCamera = PathWeights.Power(_forth[end] * _before[end + 1] / _distance2[end + 1]) * seen[end + 1].Connected(_forth[end + 1], At(end + 1));
                weights[$"connected {end}"] = Share((fromLight + fromCamera) * PathWeights.Power(_passing[end + 1]));
            }

            FloatW linked = _camera * _passing[_last] * _after[_last - 1] * (1f / CameraPaths);
            weights["seen by the camera"] = Share(PathWeights.Power(linked) * lit[_last - 1].Connected(_back[_last - 1], At(_last - 1)));
            for (int at = 1; at < _last; at++)
            {
                weights[$"merged {at}"] = Share(lit[at].Merged(_back[at], _weights) + seen[at].Merged(_forth[at], _weights));
            }

            return weights;
        }

        // The density of the vertices up to one, of light paths.
        private double Light(int to, int lane)
        {
            double density = _point[lane];
            for (int i = 1; i <= to; i++)
            {
                density *= (i == 1 ? _direction : _forth[i - 1])[lane] * _before[i][lane] / _distance2[i][lane] * _passing[i][lane];
            }

            return density;
        }

        // The density of the vertices down to one, of the camera's paths.
        private double Camera(int to, int lane)
        {
            double density = _camera[lane] * _after[_last - 1][lane] * _passing[_last][lane];
            for (int i = _last - 2; i >= to; i--)
            {
                density *= _back[i + 1][lane] * _after[i][lane] / _distance2[i + 1][lane] * _passing[i + 1][lane];
            }

            return density;
        }

        private SubpathSumsW[] LightSums()
        {
            SubpathSumsW[] sums = new SubpathSumsW[_last];
            FloatW emission = _point * _direction;
            SubpathSumsW at = default;
            at.Vc = PathWeights.Power(_after[0] / emission * _weights.PerLightPath);
            at.Vm = at.Vc * _weights.Connecting;
            at.Arrive(_distance2[1], _before[1]);
            at.Vcm = PathWeights.Power(_asked * _after[0] / (emission * _before[1]) * _weights.PerLightPath);
            at.Pass(_passing[1]);
            sums[1] = at;
            for (int i = 1; i + 1 < _last; i++)
            {
                at.Leave(_after[i], _forth[i], _back[i], _delta[i], At(i));
                at.Arrive(_distance2[i + 1], _before[i + 1]);
                at.Pass(_passing[i + 1]);
                sums[i + 1] = at;
            }

            return sums;
        }

        private SubpathSumsW[] CameraSums()
        {
            SubpathSumsW[] sums = new SubpathSumsW[_last];
            SubpathSumsW at = default;
            at.Vcm = PathWeights.Power(CameraPaths / (_camera * _after[_last - 1]));
            at.Pass(_passing[_last]);
            sums[_last - 1] = at;
            for (int i = _last - 1; i > 0; i--)
            {
                at.Leave(_before[i], _back[i], _forth[i], _delta[i], At(i));
                at.Arrive(_distance2[i], _after[i - 1]);
                at.Pass(_passing[i]);
                sums[i - 1] = at;
            }

            return sums;
        }

        private PathWeights At(int vertex) => _isInMedium[vertex] ? _weights.At(s_media) : _weights;

        private bool Has(int vertex, int lane) => (_delta[vertex].Bits >> lane & 1) != 0;

        private static FloatW Share(FloatW others) => 1f / (others + 1f);
    }
}
