using System.Globalization;
using RayTracer.Benchmarks.Standing;
using RayTracer.Testing;

namespace RayTracer.Benchmarks.Studio;

/// <summary>The scenes in which something moves, and how: each motion gives the text of the scene at a step.</summary>
internal sealed record MovingScene(string Name, string Path, int MostMilliseconds, string Dragged, string DraggedTo, string Painted, string PaintedTo)
{
    /// <summary>The motions; the first is the camera's.</summary>
    public static IReadOnlyList<string> Motions { get; } = ["orbit", "drag", "material"];

    /// <summary>The report's scenes, the Cornell box, balls of nine materials, and a million triangles.</summary>
    /// <param name="folder">Takes the scenes that are made.</param>
    public static IReadOnlyList<MovingScene> All(string folder)
    {
        StandingScenes.Write(folder);
        string Shipped(string name) => ProjectFolder.PathOf("scenes", name);
        return
        [
            new("report 1", Shipped("report/scene1.json"), 35, "\"center\": [0, 1, 0]", "\"center\": [@, 1, 0]", "\"center\": [2.4, 3.6, 2.4]", "\"center\": [@2.4, 3.6, 2.4]"),
            new("report 2", Shipped("report/scene2.json"), 35, "[-0.55, 0.6, -1.1]", "[@-0.55, 0.6, -1.1]", "[0.72, 0.09, 0.06]", "[@0.4, 0.09, 0.06]"),
            new("report 3", Shipped("report/scene3.json"), 35, "[-0.04, 0.1, 0.1]", "[@-0.04, 0.1, 0.1]", "[0.1, 0.12, -0.5]", "[@0.1, 0.12, -0.5]"),
            new("Cornell box", Shipped("cornell.json"), 35, "[-0.35, 0, -0.3]", "[@-0.35, 0, -0.3]", "[0.14, 0.45, 0.091]", "[@0.14, 0.45, 0.091]"),
            new("shader balls", System.IO.Path.Combine(folder, "shader-balls.json"), 50, "\"car paint\", \"transform\": [{ \"translate\": [-5, 0, 0]", "\"car paint\", \"transform\": [{ \"translate\": [@-5, 0, 0]", "[0.07, 0.075, 0.085]", "[@0.07, 0.075, 0.085]"),
            new("a million triangles", System.IO.Path.Combine(folder, "million-triangles.json"), 50, "\"irradiance\": [2, 2, 2]", "\"irradiance\": [@2, 2, 2]", "[0.7, 0.6, 0.5]", "[@0.7, 0.6, 0.5]"),
        ];
    }

    /// <summary>The scene at a step of a motion.</summary>
    public string TextAt(string motion, int step)
    {
        string text = File.ReadAllText(Path);
        return motion switch
        {
            "drag" => text.Replace(Dragged, At(DraggedTo, 0.02 * step), StringComparison.Ordinal),
            "material" => text.Replace(Painted, At(PaintedTo, 0.015 * step), StringComparison.Ordinal),
            _ => text,
        };
    }

    // "@0.4" stands for 0.4 and what has been gone.
    private static string At(string pattern, double gone) => System.Text.RegularExpressions.Regex.Replace(
        pattern, "@(-?[0-9.]*)", m => ((m.Groups[1].Value.Length > 0 ? double.Parse(m.Groups[1].Value, CultureInfo.InvariantCulture) : 0) + gone).ToString(CultureInfo.InvariantCulture),
        System.Text.RegularExpressions.RegexOptions.None, TimeSpan.FromSeconds(1));
}
