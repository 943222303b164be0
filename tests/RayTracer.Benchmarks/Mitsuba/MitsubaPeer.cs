using System.Diagnostics;
using System.Globalization;

namespace RayTracer.Benchmarks.Mitsuba;

/// <summary>Mitsuba in a process of its own, with a scene.</summary>
internal sealed class MitsubaPeer : IDisposable
{
    private readonly Process _process;

    /// <param name="scene">The file of the scene.</param>
    /// <param name="samples">Samples per pixel, where a render names none.</param>
    /// <exception cref="InvalidOperationException">Python cannot import Mitsuba.</exception>
    public MitsubaPeer(string scene, int samples)
    {
        ProcessStartInfo start = new(Environment.GetEnvironmentVariable("RAYTRACER_PYTHON") ?? "python3") { UseShellExecute = false, RedirectStandardInput = true, RedirectStandardOutput = true };
        foreach (string argument in new[] { Path.Combine(AppContext.BaseDirectory, "Mitsuba", "peer.py"), scene, samples.ToString(CultureInfo.InvariantCulture) })
        {
            start.ArgumentList.Add(argument);
        }

        _process = Process.Start(start)!;
        Version = _process.StandardOutput.ReadLine() ?? throw new InvalidOperationException("No Mitsuba: python3 cannot import it (PYTHONPATH, DRJIT_LIBLLVM_PATH).");
    }

    /// <summary>Its version.</summary>
    public string Version { get; }

    /// <summary>Renders, and says how many seconds that took.</summary>
    /// <param name="seed">The seed.</param>
    /// <param name="request">Other samples, and a file for the picture: <c>64 picture.pfm</c>.</param>
    public (double Wall, double Processor) Render(int seed, string request = "")
    {
        _process.StandardInput.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{seed} {request}"));
        string[] answer = (_process.StandardOutput.ReadLine() ?? throw new InvalidOperationException("Mitsuba has ended.")).Split(' ');
        return (double.Parse(answer[0], CultureInfo.InvariantCulture), double.Parse(answer[1], CultureInfo.InvariantCulture));
    }

    public void Dispose()
    {
        _process.StandardInput.Close();
        _process.WaitForExit();
        _process.Dispose();
    }
}
