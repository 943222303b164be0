using RayTracer.Description;
using RayTracer.Imaging;

namespace RayTracer.Jobs;

/// <summary>
/// Keeps with pictures and films how a display shows them, as a text of one or two words: a tone map, and an exposure that is not 0.
/// </summary>
public static class PictureTone
{
    /// <summary>The key of the text; it is missing where light is shown as it is.</summary>
    public const string Key = "Tone";

    /// <summary>The text for options; null where light is shown as it is.</summary>
    public static string? Text(ImageWriteOptions writing)
    {
        (ToneMap map, Exposure exposure) = (writing.ToneMap ?? ToneMap.Clamp, writing.Exposure ?? default);
        return (map, exposure) == (ToneMap.Clamp, default) ? null
            : $"{map.ToString().ToLowerInvariant()}{(exposure == default ? "" : $" {exposure}")}";
    }

    /// <summary>The options with those of a text, where none are given.</summary>
    /// <param name="writing">The options.</param>
    /// <param name="text">The text; null for light as it is.</param>
    /// <exception cref="JobException">It is not understood.</exception>
    public static ImageWriteOptions With(this ImageWriteOptions writing, string? text)
    {
        try
        {
            string[] words = text?.Split(' ') ?? [];
            return writing with
            {
                ToneMap = writing.ToneMap ?? (words is [var map, ..]
                    ? OptionWords.Choice(map, OptionWords.Of<ToneMap>(), Enum.GetValues<ToneMap>()) : ToneMap.Clamp),
                Exposure = writing.Exposure ?? (words is [_, var stops] ? OptionWords.Exposure(stops) : default),
            };
        }
        catch (FormatException e)
        {
            throw new JobException($"the text {Key} is not understood: {e.Message}", e);
        }
    }

    /// <summary>
    /// The options with those of an image that was read: of a display's image light as it is, else those of its text, and of an image of
    /// another program the soft tone map.
    /// </summary>
    /// <param name="writing">The options.</param>
    /// <param name="path">The image's file.</param>
    /// <param name="texts">The image's texts.</param>
    public static ImageWriteOptions OfImage(
        this ImageWriteOptions writing, string path, IEnumerable<KeyValuePair<string, string>> texts)
    {
        Dictionary<string, string> all = texts.GroupBy(t => t.Key).ToDictionary(g => g.Key, g => g.First().Value);
        bool isForDisplay = ImageFile.FormatOf(path) is not { } format || format.Features.HasFlag(ImageFeatures.Display);
        return writing.With(isForDisplay ? null : all.TryGetValue(Key, out string? tone) ? tone
            : all.ContainsKey(PictureTexts.CommandKey) ? null : ToneMap.Soft.ToString());
    }
}
