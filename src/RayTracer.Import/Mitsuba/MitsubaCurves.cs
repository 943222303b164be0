using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>
/// Makes curves of straight pieces: what a ball covers that goes along them while its radius changes evenly. That is a ball at each point, and between two of them the cone
/// that touches both.
/// </summary>
internal static class MitsubaCurves
{
    // Of a cone and a ball of a scene.
    private const long BytesPerPoint = 2000;

    /// <summary>The curves of a file; null after an error.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="material">Its material.</param>
    public static GroupDescription? Read(MitsubaObject shape, MaterialDescription material)
    {
        Transform place = shape.Transform();
        SourcePlace at = shape.PlaceOf("filename");
        string? unlike = shape.Only("emitter") is not null ? "curves that shine"
            : FilledMaterials.Fill(material, new()) is not null ? "curves that let light in" : MaterialTextures.NeedUv(material) ? "textures on curves" : null;
        if (unlike is not null)
        {
            shape.Log.Unsupported(shape.Place, $"{unlike} are not supported", "the picture differs there");
        }

        if (shape.FileName() is null || Points(shape.PathOf(shape.Text("filename")!), shape.Text("filename")!, at, shape.Log) is not { } curves)
        {
            return null;
        }

        long count = curves.Sum(c => (long)c.Count);
        if (SceneBudget.Open?.Take($"a curve of {count} points", count * BytesPerPoint, count) is { } complaint)
        {
            return shape.Log.Fail<GroupDescription>(at, complaint);
        }

        // Radii stay as they are, whatever the scale.
        List<ShapeDescription> parts = [];
        foreach (List<Vector4> curve in curves)
        {
            Vector4[] points = [.. curve.Select(p => new Vector4(place.Point(p.AsVector3()), p.W))];
            parts.AddRange(points.Where(p => p.W > 0).Select(p => new SphereDescription { Center = p.AsVector3(), Radius = p.W, Material = material }));
            parts.AddRange(points.Zip(points.Skip(1), (p, q) => p.W < q.W ? Between(q, p, material) : Between(p, q, material)).OfType<ConeDescription>());
        }

        return new() { Shapes = parts };
    }

    // The cone that touches two balls, the larger one first; null where it holds the other.
    private static ConeDescription? Between(Vector4 larger, Vector4 smaller, MaterialDescription material)
    {
        Vector3 way = smaller.AsVector3() - larger.AsVector3();
        float length = way.Norm();
        float sine = (larger.W - smaller.W) / length;
        if (!(larger.W > 0 && sine < 1))
        {
            return null;
        }

        // The normals of the cone lean forwards, and so its ends lie beside the balls' middles.
        (Vector3 lean, float cosine) = (way * (sine / length), float.Sqrt(1 - (sine * sine)));
        return new()
        {
            Bottom = larger.AsVector3() + (lean * larger.W),
            Top = smaller.AsVector3() + (lean * smaller.W),
            Radius = larger.W * cosine,
            TopRadius = smaller.W * cosine,
            Caps = false,
            Material = material,
        };
    }

    // Points with radii, a line each; empty lines are between curves.
    private static List<List<Vector4>>? Points(string path, string name, SourcePlace place, ImportLog log)
    {
        try
        {
            if ((FileSearch.Complaint(path) ?? SceneBudget.Open?.TakeWork("a file of curves", new FileInfo(path).Length, new FileInfo(path).Length)) is { } complaint)
            {
                return log.Fail<List<List<Vector4>>>(place, $"cannot read {Quotation.Of(name)}: {complaint}");
            }

            List<List<Vector4>> curves = [[]];
            foreach (string[] words in File.ReadLines(path).Select(MitsubaNumbers.Words))
            {
                float[] numbers = [.. words.Select(w => float.TryParse(w, NumberStyles.Float, CultureInfo.InvariantCulture, out float n) && float.IsFinite(n) ? n : float.NaN)];
                if (numbers.Length > 0 && !(numbers.Length == 4 && numbers.All(float.IsFinite) && numbers[3] >= 0))
                {
                    return log.Fail<List<List<Vector4>>>(place, $"{Quotation.Of(name)} holds no curves: expected three coordinates and a radius per line, but found {Quotation.Of(string.Join(' ', words))}");
                }

                if (numbers.Length > 0)
                {
                    curves[^1].Add(new(numbers));
                }
                else if (curves[^1].Count > 0)
                {
                    curves.Add([]);
                }
            }

            curves.RemoveAll(c => c.Count == 0);
            return curves.Count > 0 && curves.TrueForAll(c => c.Count > 1) ? curves
                : log.Fail<List<List<Vector4>>>(place, $"{Quotation.Of(name)} holds no curves: each needs two points or more");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            return log.Fail<List<List<Vector4>>>(place, $"cannot read {Quotation.Of(name)}: {e.Message.TrimEnd('.')}");
        }
    }
}
