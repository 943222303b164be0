using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Makes phase functions.</summary>
internal static class MitsubaPhases
{
    private static readonly Rgb s_half = new(0.5f, 0.5f, 0.5f);

    /// <summary>The phase function that a thing is.</summary>
    /// <param name="phase">The thing.</param>
    /// <param name="depth">In how many others it is.</param>
    public static PhaseDescription Read(MitsubaObject phase, int depth = 0)
    {
        PhaseDescription? read = phase.Type switch
        {
            "isotropic" => new(),
            "hg" => new() { Anisotropy = phase.Float("g", 0.8f, -0.99f, 0.99f) },
            "rayleigh" => new() { Shape = PhaseShape.Rayleigh },
            "tabphase" => Table(phase),
            "blendphase" => Blend(phase, depth),
            "sggx" => Flakes(phase, depth),
            _ => null,
        };
        if (read is null)
        {
            phase.UnknownType("phase functions", "isotropic", "hg", "rayleigh", "tabphase", "blendphase", "sggx");
            return new();
        }

        phase.Finish();
        return read;
    }

    private static PhaseDescription Table(MitsubaObject phase)
    {
        string[] words = MitsubaNumbers.Words(phase.Text("values") ?? "");
        float?[] values = [.. words.Take(PhaseDescription.LongestTable + 1).Select(w => MitsubaNumbers.Float(w, phase.PlaceOf("values"), phase.Log))];
        if (values.Contains(null))
        {
            return new();
        }

        PhaseDescription table = new() { Shape = PhaseShape.Table, Values = [.. values.Select(v => v!.Value)] };
        string? complaint = table.Values.Any(v => v < 0) ? "the values of a phase function must be at least 0" : table.TableComplaint;
        return complaint is null ? table : phase.Log.Fail<PhaseDescription>(phase.PlaceOf("values"), complaint) ?? new();
    }

    // Of constant volumes Mitsuba knows only numbers and colours.
    private static PhaseDescription Flakes(MitsubaObject phase, int depth)
    {
        (_, GridDescription? grid) = MitsubaMedia.Volume(phase, "S", Rgb.White, float.PositiveInfinity);
        if (grid is null && !phase.LacksSomething)
        {
            phase.Log.Error(phase.Place, "phase \"sggx\" needs a \"gridvolume\" of six channels as \"S\"");
        }

        if (depth > 0)
        {
            phase.Log.Error(phase.TypePlace, "\"sggx\" within \"blendphase\" is not supported: it also says how much light the medium weakens");
        }

        return grid is null || depth > 0 ? new() : new() { Shape = PhaseShape.Sggx, MatrixGrid = grid };
    }

    private static PhaseDescription Blend(MitsubaObject phase, int depth)
    {
        (Rgb weight, GridDescription? grid) = MitsubaMedia.Volume(phase, "weight", s_half, 1);
        MitsubaObject[] parts = [.. phase.Children("phase")];
        if (parts.Length != 2 && !phase.LacksSomething)
        {
            phase.Log.Error(phase.Place, $"{phase.Describe()} needs 2 phase functions within it, but has {parts.Length}");
        }

        if (weight.R != weight.G || weight.R != weight.B)
        {
            phase.Log.Error(phase.PlaceOf("weight"), "a weight is one number, not a colour");
        }

        if (depth == PhaseDescription.Deepest)
        {
            phase.Log.Error(phase.Place, PhaseDescription.DepthComplaint);
        }

        return parts.Length != 2 || depth == PhaseDescription.Deepest ? new()
            : new() { Shape = PhaseShape.Mix, First = Read(parts[0], depth + 1), Second = Read(parts[1], depth + 1), Weight = weight.R, WeightGrid = grid };
    }
}
