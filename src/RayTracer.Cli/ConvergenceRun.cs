using System.Text.Json.Nodes;
using System.Xml.Linq;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Scenes;
using RayTracer.Study;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>Renders a scene with several integrators, and says and draws how their errors fall.</summary>
/// <param name="job">The scene with its settings.</param>
/// <param name="reference">The name of the picture without noise.</param>
/// <param name="time">The time for which each integrator renders.</param>
/// <param name="streams">The streams to write to.</param>
internal sealed class ConvergenceRun(RenderJob job, string reference, TimeSpan time, Streams streams)
{
    private readonly List<ErrorCurve> _curves = [];
    private readonly List<(Integrator Integrator, string Reason)> _leftOut = [];

    /// <summary>Takes a line for each integrator.</summary>
    public required TextWriter Table { get; init; }

    /// <summary>What was measured.</summary>
    public IReadOnlyList<ErrorCurve> Curves => _curves;

    /// <summary>Renders; says which integrators cannot, and why.</summary>
    /// <param name="integrators">The integrators, in their order.</param>
    /// <param name="picture">The picture without noise.</param>
    /// <param name="change">Changes the scene before it is built.</param>
    /// <param name="known">The diagnostics of the scene so far.</param>
    /// <param name="cancellation">Ends the rendering; what was measured stays.</param>
    public void Measure(
        IReadOnlyList<Integrator> integrators, Picture picture, Func<SceneDescription, SceneDescription> change, IEnumerable<Diagnostic> known, CancellationToken cancellation)
    {
        HashSet<string> said = [.. known.Select(d => d.Message)];
        ConvergenceStudy study = new(picture, time);
        Table.WriteLine($"{"integrator",-16}{"samples",9}{"seconds",10}{"relMSE",12}{"over all",12}{"× below path",14}{"slope",8}");
        foreach (Integrator integrator in integrators.TakeWhile(_ => !cancellation.IsCancellationRequested))
        {
            SceneLoadResult loaded = job.With([$"render.integrator={integrator.Name}"]).Load(change);
            if (loaded.Scene is not { } scene)
            {
                string reason = string.Join("; ", loaded.Diagnostics.Where(d => d.Severity == Severity.Error).Select(d => d.Message));
                _leftOut.Add((integrator, reason));
                streams.Warn($"{integrator.Name} is left out: {reason}");
                continue;
            }

            streams.Read([.. loaded.Diagnostics.Where(d => said.Add(d.Message))]);
            if (study.Measure(scene, cancellation) is { Count: > 0 } points)
            {
                _curves.Add(new(integrator, points));
                Table.WriteLine(Row(_curves[^1]));
            }
        }
    }

    /// <summary>Prints what the table does not say, and draws the chart: last, so that a full disk loses no figures.</summary>
    /// <param name="chart">The chart's file; null for none.</param>
    /// <param name="isJson">True if a JSON object is printed.</param>
    public void Finish(string? chart, bool isJson)
    {
        XDocument? drawing = chart is null ? null : ConvergenceChart.Draw($"{Path.GetFileName(job.Scene)}, {Environment.ProcessorCount} threads", _curves);
        string[] outputs = drawing is null ? [] : [chart!];
        if (isJson)
        {
            JsonText.Write(streams, Json(outputs));
        }

        if (drawing is not null)
        {
            AtomicFile.Write(chart!, drawing.Save);
        }
        else if (chart is not null)
        {
            streams.Warn($"'{chart}' was not written: no error above 0 was measured");
        }

        if (!isJson)
        {
            streams.Wrote(outputs);
        }
    }

    private double? FactorBelowPath(ErrorCurve curve) =>
        _curves.Find(c => c.Integrator == Integrator.Path)?.At(curve.Last.Seconds) / curve.Last.Error.Trimmed;

    private string Row(ErrorCurve curve)
    {
        ErrorPoint last = curve.Last;
        return $"{curve.Integrator.Name,-16}{last.Samples,9}{last.Seconds,10:F2}{last.Error.Trimmed,12:G4}{last.Error.Whole,12:G4}"
            + $"{FactorBelowPath(curve)?.ToString("F2", null) ?? "–",14}{curve.Slope?.ToString("F2", null) ?? "–",8}";
    }

    private JsonObject Json(IEnumerable<string> outputs) => new()
    {
        ["scene"] = job.Scene,
        ["reference"] = reference,
        ["threads"] = Environment.ProcessorCount,
        ["integrators"] = JsonText.List(_curves.Select(c => new JsonObject
        {
            ["integrator"] = c.Integrator.Name,
            ["factorBelowPath"] = FactorBelowPath(c) is { } factor ? JsonText.Number(factor) : null,
            ["slope"] = c.Slope,
            ["points"] = JsonText.List(c.Points.Select(p => new JsonObject
            {
                ["seconds"] = p.Seconds,
                ["samplesPerPixel"] = p.Samples,
                ["relativeMse"] = JsonText.Number(p.Error.Whole),
                ["relativeMseTrimmed"] = JsonText.Number(p.Error.Trimmed),
            })),
        })),
        ["leftOut"] = JsonText.List(_leftOut.Select(l => new JsonObject { ["integrator"] = l.Integrator.Name, ["reason"] = l.Reason })),
        ["outputs"] = JsonText.List(outputs),
    };
}
