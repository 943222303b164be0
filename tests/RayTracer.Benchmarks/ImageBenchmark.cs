using System.Diagnostics;
using System.Globalization;
using RayTracer.Imaging;

namespace RayTracer.Benchmarks;

/// <summary>
/// Reading PNG and JPEG files here, warm, against the common libraries' own commands (libpng's pngtopnm, libjpeg-turbo's djpeg), in turn, by
/// processor time; and the memory that reading takes, against that of the picture's floats.
/// </summary>
internal static class ImageBenchmark
{
    private const int Rounds = 7;

    public static int Run(string[] paths)
    {
        foreach (string path in paths)
        {
            byte[] file = File.ReadAllBytes(path);
            string peer = file.AsSpan().StartsWith(PngReader.Signature) ? "pngtopnm" : "djpeg";
            double own = double.PositiveInfinity;
            double peers = double.PositiveInfinity;
            long pixels = 0;
            for (int round = 0; round < Rounds; round++)
            {
                own = Math.Min(own, ProcessorTime(() => pixels = ImageFile.Decode(file).Pixels.LongLength / 3));
                peers = Math.Min(peers, PeerTime(peer, path));
            }

            long before = GC.GetTotalAllocatedBytes();
            ImageFile.Decode(file);
            double memory = (GC.GetTotalAllocatedBytes() - before) / (12.0 * pixels);
            Console.WriteLine($"{Path.GetFileName(path)}: {pixels / 1e6:F1} million pixels in {own:F3} s; {peer} {peers:F3} s; ratio {own / peers:F2}; memory {memory:F2} times the pixels");
        }

        return 0;
    }

    private static double ProcessorTime(Action action)
    {
        GC.Collect();
        TimeSpan before = Environment.CpuUsage.TotalTime;
        action();
        return (Environment.CpuUsage.TotalTime - before).TotalSeconds;
    }

    // Bash gives the processor time of a process that has ended, which the runtime does not.
    private static double PeerTime(string program, string path)
    {
        ProcessStartInfo start = new("bash", ["-c", "TIMEFORMAT='%U %S'; time \"$0\" \"$1\" > /dev/null", program, path]) { RedirectStandardError = true, UseShellExecute = false };
        using Process process = Process.Start(start)!;
        string last = process.StandardError.ReadToEnd().TrimEnd().Split('\n')[^1];
        process.WaitForExit();
        return last.Split(' ').Sum(seconds => double.Parse(seconds, CultureInfo.InvariantCulture));
    }
}
