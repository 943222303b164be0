using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>The light of a picture, kept apart for each of its lights; on the render loop's thread.</summary>
internal sealed class LightLayers
{
    /// <summary>The name of what is seen behind everything.</summary>
    public const string Background = "background";

    /// <summary>The name of light without a source.</summary>
    public const string Ambient = "ambient";

    private const long MostBytes = 1L << 30;
    private static readonly LightPathAov[] s_kinds = [LightPathAov.Lights];
    private GoodScene? _of;
    private Film? _beside;

    /// <summary>The layers, which the renderer fills; null where there are none.</summary>
    public LightPathAovFilm? Film { get; private set; }

    /// <summary>The name of the layer of a light.</summary>
    public static string NameOf(ShapeDescription light) => LightGroupLabel.Of(light, null)?.Text ?? "unnamed";

    /// <summary>The name of the layer of the surroundings.</summary>
    public static string NameOf(EnvironmentDescription around) => LightGroupLabel.Plain(around.LightGroup) ?? "environment";

    /// <summary>The names of a scene's layers; none where its light cannot be kept apart.</summary>
    public static IReadOnlyList<string> NamesOf(ViewportScene shown) =>
        Complaint(shown) is null ? [.. LightPathAovFilm.NamesOf(shown.Scene, s_kinds).Select(n => n[LightPathAovFilm.LightPrefix.Length..])] : [];

    /// <summary>Makes sure that a scene's light can be kept apart.</summary>
    /// <exception cref="SessionException">It cannot.</exception>
    public static void Check(ViewportScene shown)
    {
        if (Complaint(shown) is { } complaint)
        {
            throw new SessionException(complaint);
        }
    }

    /// <summary>A picture begins; layers of the same scene and film are used again.</summary>
    public void Begin(ViewportScene wanted, Film film)
    {
        bool isKept = ReferenceEquals(_of, wanted.Good) && ReferenceEquals(_beside, film);
        (_of, _beside) = (wanted.Good, film);
        Film = wanted.Settings.LightFactors is null || Complaint(wanted) is not null ? null : isKept && Film is not null ? Film : new(film, wanted.Scene, s_kinds);
        Film?.Clear();
    }

    /// <summary>Adds to a picture what the factors on lights make of it.</summary>
    /// <param name="wanted">What is shown.</param>
    /// <param name="to">The picture with all lights as they are.</param>
    public void Paint(ViewportScene wanted, LinearPicture to) => Mix(wanted, (y, more) =>
    {
        Span<float> row = to.Row(y);
        for (int i = 0; i < more.Length; i++)
        {
            row[i] += more[i];
        }
    }, to.Height);

    /// <summary>Tells what the factors on lights add to each row of a picture; of no rows where they add nothing.</summary>
    /// <param name="wanted">What is shown.</param>
    /// <param name="add">Takes a row, and what is added to its reds, greens and blues; on several threads.</param>
    /// <param name="height">The number of rows.</param>
    public void Mix(ViewportScene wanted, MixedRow add, int height)
    {
        if (Film is not { } film || wanted.Settings.LightFactors is not { } factors)
        {
            return;
        }

        (IImageRows Image, Rgb More)[] changed = [.. film.Names.Select((name, i) => (Image: film.Image(i), Name: name[LightPathAovFilm.LightPrefix.Length..]))
            .Where(l => factors.ContainsKey(l.Name)).Select(l => (l.Image, factors[l.Name] + (Rgb.White * -1))).Where(l => !l.Item2.IsBlack)];
        Parallel.For(0, changed.Length == 0 ? 0 : height, new ParallelOptions { MaxDegreeOfParallelism = wanted.Settings.Threads }, y =>
        {
            float[] light = new float[3 * changed[0].Image.Width];
            float[] sum = new float[light.Length];
            foreach ((IImageRows image, Rgb more) in changed)
            {
                image.ReadRow(y, light);
                for (int i = 0; i < light.Length; i += 3)
                {
                    sum[i] += more.R * light[i];
                    sum[i + 1] += more.G * light[i + 1];
                    sum[i + 2] += more.B * light[i + 2];
                }
            }

            add(y, sum);
        });
    }

    private static string? Complaint(ViewportScene shown)
    {
        try
        {
            LightPathAovFilm.NamesOf(shown.Scene, s_kinds);
        }
        catch (ArgumentException e)
        {
            return e.Message.Split(" (Parameter '")[0];
        }

        return shown.Settings.Edition is not null ? "The textbook edition does not keep the light of lamps apart: choose the fast edition."
            : LightPathAovFilm.Bytes(s_kinds, shown.Scene) > MostBytes ? "The picture has too many pixels and lights to keep their light apart."
            : null;
    }
}

/// <summary>Takes what is added to a row of a picture.</summary>
/// <param name="y">The row.</param>
/// <param name="more">What is added to its reds, greens and blues.</param>
internal delegate void MixedRow(int y, ReadOnlySpan<float> more);
