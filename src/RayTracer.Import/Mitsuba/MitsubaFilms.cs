using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>The settings of a film for a picture.</summary>
/// <param name="Render">Size and filter.</param>
/// <param name="Window">The part of the whole film that is shown, as <see cref="CameraDescription.Window"/>; empty for all of it.</param>
internal sealed record FilmRead(RenderDescription Render, IReadOnlyList<float> Window);

/// <summary>Reads films: sizes, crops and pixel filters.</summary>
internal static class MitsubaFilms
{
    private const int StandardWidth = 768;
    private const int StandardHeight = 576;

    /// <summary>The settings of a film; null stands for the default film.</summary>
    public static FilmRead Read(MitsubaObject? film, RenderDescription render)
    {
        if (film is null)
        {
            return new(render with { Width = StandardWidth, Height = StandardHeight, Filter = Gaussian(0.5f) }, []);
        }

        if (film.Type != "hdrfilm")
        {
            film.UnknownType("films", "hdrfilm");
        }

        film.Ignore("file_format", "pixel_format", "component_format", "sample_border", "compensate", "banner");
        int width = film.Integer("width", StandardWidth, 1);
        int height = film.Integer("height", StandardHeight, 1);
        FilterDescription filter = film.Only("rfilter") is { } rfilter ? Filter(rfilter) : Gaussian(0.5f);
        FilmRead read = Crop(film, render with { Width = width, Height = height, Filter = filter });
        film.Finish();
        return read;
    }

    private static FilmRead Crop(MitsubaObject film, RenderDescription render)
    {
        int x = film.Integer("crop_offset_x", 0, 0);
        int y = film.Integer("crop_offset_y", 0, 0);
        int width = film.Integer("crop_width", render.Width, 1);
        int height = film.Integer("crop_height", render.Height, 1);
        if (x + (long)width > render.Width || y + (long)height > render.Height)
        {
            film.Log.Error(film.Has("crop_width") ? film.PlaceOf("crop_width") : film.Place, $"the crop reaches beyond the film of {render.Width}×{render.Height} pixels");
            return new(render, []);
        }

        bool isAll = width == render.Width && height == render.Height;
        float[] window = [x / (float)render.Width, y / (float)render.Height, width / (float)render.Width, height / (float)render.Height];
        return new(render with { Width = width, Height = height }, isAll ? [] : window);
    }

    private static FilterDescription Filter(MitsubaObject filter)
    {
        FilterDescription? read = filter.Type switch
        {
            "box" => new(),
            "tent" => new() { Shape = FilterShape.Tent, Radius = filter.Float("radius", 1, 0) },
            "gaussian" => Gaussian(filter.Float("stddev", 0.5f, 0)),
            "mitchell" => new() { Shape = FilterShape.Mitchell, B = filter.Float("A", 1f / 3), C = filter.Float("B", 1f / 3) },
            "catmullrom" => new() { Shape = FilterShape.Mitchell, B = 0, C = 0.5f },
            _ => null,
        };
        if (read is null)
        {
            filter.UnknownType("filters", "box", "tent", "gaussian", "mitchell", "catmullrom");
            return new();
        }

        filter.Finish();
        return read;
    }

    // It ends after four deviations.
    private static FilterDescription Gaussian(float deviation) => new() { Shape = FilterShape.Gaussian, Deviation = deviation, Radius = 4 * deviation };
}
