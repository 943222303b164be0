using System.Diagnostics;
using System.Globalization;
using System.Runtime.InteropServices;
using RayTracer.Imaging;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Benchmarks.Mitsuba;

/// <summary>
/// A cloud of 128³ points against Mitsuba's volume integrators: both read the same files, and each is compared with its own converged picture. What counts is the time to the
/// same noise: processor time × relative squared error.
/// </summary>
internal static class CloudBenchmark
{
    private const int Points = 128;
    private const int Size = 128;

    // So many times the samples make a picture converged: its own error adds a part of 1/32.
    private const int Converged = 32;

    /// <param name="samples">Samples per pixel.</param>
    /// <param name="rounds">How often each renders; the best round counts.</param>
    public static void Run(int samples, int rounds)
    {
        string folder = Directory.CreateTempSubdirectory("raytracer-cloud-").FullName;
        try
        {
            WriteGrid(Path.Combine(folder, "cloud.vol"));
            foreach (string integrator in (string[])["volpath", "volpathmis"])
            {
                string scene = Path.Combine(folder, "cloud.xml");
                File.WriteAllText(scene, Scene(integrator));
                Compare(scene, integrator, samples, rounds);
            }
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static void Compare(string scene, string integrator, int samples, int rounds)
    {
        string file = Path.ChangeExtension(scene, ".pfm");
        Picture Theirs(MitsubaPeer peer, int seed, int count, out (double Wall, double Processor) time)
        {
            time = peer.Render(seed, string.Create(CultureInfo.InvariantCulture, $"{count} {file}"));
            return ImageFile.Read(file);
        }

        using MitsubaPeer peer = new(scene, samples);
        (Picture mine, Picture theirs) = (Ours(scene, Converged * samples, 1000, out _), Theirs(peer, 1000, Converged * samples, out _));
        (double Wall, double Processor) best = (double.PositiveInfinity, double.PositiveInfinity);
        (double Wall, double Processor) others = best;
        (double error, double othersError) = (0, 0);
        for (int round = 0; round <= rounds; round++)
        {
            othersError += Error(Theirs(peer, round, samples, out (double Wall, double Processor) first), theirs) / (rounds + 1);
            error += Error(Ours(scene, samples, round, out (double Wall, double Processor) second), mine) / (rounds + 1);
            if (round > 0)
            {
                (others, best) = (MitsubaBenchmark.Best(others, first), MitsubaBenchmark.Best(best, second));
            }
        }

        Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"""
            cloud, {samples} samples, Mitsuba {peer.Version} {integrator}: mean {Mean(mine):F4} against {Mean(theirs):F4}; processor time {others.Processor / best.Processor:F2} times, relative squared error {othersError / error:F2} times; time to the same noise {others.Processor * othersError / (best.Processor * error):F2} times
            """));
    }

    private static Picture Ours(string file, int samples, int seed, out (double Wall, double Processor) time)
    {
        Rendering.Scene scene = SceneLoader.Load(file, s => s with { Render = s.Render with { SamplesPerPixel = samples, Seed = seed } }).Scene ?? throw new InvalidOperationException("The cloud cannot be read.");
        TimeSpan before = Environment.CpuUsage.TotalTime;
        long start = Stopwatch.GetTimestamp();
        Film film = new RTracer(scene, new()).Render().Film;
        time = (Stopwatch.GetElapsedTime(start).TotalSeconds, (Environment.CpuUsage.TotalTime - before).TotalSeconds);
        return film.ToPicture();
    }

    private static double Mean(Picture picture) => picture.Pixels.Average(p => (double)p);

    // The mean of the squared error over the squared value, which keeps dark places from counting without end.
    private static double Error(Picture picture, Picture converged) =>
        picture.Pixels.Zip(converged.Pixels, (a, b) => (double)(a - b) * (a - b) / (((double)b * b) + 1e-3)).Average();

    private static void WriteGrid(string path)
    {
        VolumeGrid grid = new DensityNoiseDescription { Resolution = Points, Octaves = 6, Scale = 3, Threshold = 0.36f, Falloff = 0.35f, Seed = 5 }.Build(new())!.Grid;
        float[] values = new float[grid.Numbers];
        for (long i = 0; i < values.Length; i++)
        {
            // Denser than the noise, so that the cloud has a surface.
            values[i] = float.Min(5 * grid.Values[(int)i], 1);
        }

        using BinaryWriter writer = new(File.Create(path));
        writer.Write([(byte)'V', (byte)'O', (byte)'L', (byte)3]);
        foreach (int number in (int[])[1, Points, Points, Points, 1])
        {
            writer.Write(number);
        }

        foreach (float corner in (float[])[0, 0, 0, 1, 1, 1])
        {
            writer.Write(corner);
        }

        writer.Write(MemoryMarshal.AsBytes(values.AsSpan()));
    }

    private static string Scene(string integrator) => string.Create(CultureInfo.InvariantCulture, $"""
        <scene version="3.0.0">
            <integrator type="{integrator}"><integer name="max_depth" value="64"/><integer name="rr_depth" value="16"/></integrator>
            <sensor type="perspective">
                <float name="fov" value="40"/>
                <transform name="to_world"><lookat origin="0, -0.4, 3.1" target="0, 0, 0" up="0, 1, 0"/></transform>
                <film type="hdrfilm"><integer name="width" value="{Size}"/><integer name="height" value="{Size}"/><rfilter type="box"/></film>
                <sampler type="independent"/>
            </sensor>
            <emitter type="constant"><rgb name="radiance" value="0.3, 0.4, 0.6"/></emitter>
            <emitter type="directional"><vector name="direction" x="-1" y="-1.5" z="-0.5"/><rgb name="irradiance" value="3, 2.8, 2.5"/></emitter>
            <shape type="cube">
                <bsdf type="null"/>
                <medium name="interior" type="heterogeneous">
                    <float name="scale" value="40"/>
                    <volume name="sigma_t" type="gridvolume">
                        <string name="filename" value="cloud.vol"/>
                        <transform name="to_world"><scale value="2"/><translate x="-1" y="-1" z="-1"/></transform>
                    </volume>
                    <float name="albedo" value="0.99"/>
                    <phase type="hg"><float name="g" value="0.75"/></phase>
                </medium>
            </shape>
        </scene>
        """);
}
