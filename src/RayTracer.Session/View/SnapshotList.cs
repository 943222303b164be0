using System.Globalization;
using RayTracer.Imaging;

namespace RayTracer.Session;

/// <summary>Earlier pictures, kept for comparison: the newest few.</summary>
/// <param name="view">The view that they are taken of.</param>
/// <param name="time">The clock.</param>
public sealed class SnapshotList(PictureView view, TimeProvider time)
{
    private const int Most = 8;
    private readonly Lock _lock = new();
    private readonly List<(Snapshot Snapshot, LinearPicture Picture, Tone Tone)> _kept = [];
    private int _lastId;
    private (int Image, int Reference, PictureComparison Found)? _compared;

    /// <summary>Raised after each change.</summary>
    public event Action? Changed;

    /// <summary>The pictures, the oldest first.</summary>
    public IReadOnlyList<Snapshot> All => _lock.Read(() => _kept.Select(k => k.Snapshot).ToArray());

    /// <summary>Keeps the picture as it is, with its exposure and tone map.</summary>
    /// <exception cref="SessionException">There is no picture yet.</exception>
    public async Task<Snapshot> Capture()
    {
        LinearPicture picture = new();
        (int samples, int document) = await view.Loop.ReadFilm((film, shown, count) =>
        {
            picture.CopyFrom(film);
            return (count, shown.Good.Document);
        }).ConfigureAwait(false);
        Snapshot snapshot;
        lock (_lock)
        {
            string name = SessionTexts.Of("compare.picture", ++_lastId);
            snapshot = new(_lastId, name, samples, time.GetLocalNow().ToString("HH:mm:ss", CultureInfo.InvariantCulture)) { Document = document };
            _kept.Add((snapshot, picture, view.Tone));
            if (_kept.Count > Most)
            {
                _kept.RemoveAt(0);
            }
        }

        Changed?.Invoke();
        return snapshot;
    }

    /// <summary>Gives a picture another name, or keeps it no longer.</summary>
    /// <param name="id">The picture.</param>
    /// <param name="name">Its name; null to keep it no longer, which does nothing where it is not kept.</param>
    /// <exception cref="SessionException">It is not kept, and cannot get a name.</exception>
    public void Rename(int id, string? name)
    {
        lock (_lock)
        {
            if (name is null)
            {
                // A second click is on its way before the first has taken the picture off the strip.
                _kept.RemoveAll(k => k.Snapshot.Id == id);
            }
            else if (_kept.IndexOf(Find(id)) is var at && !string.IsNullOrWhiteSpace(name))
            {
                _kept[at] = _kept[at] with { Snapshot = _kept[at].Snapshot with { Name = name.Trim() } };
            }
        }

        Changed?.Invoke();
    }

    /// <summary>A picture as a PNG.</summary>
    /// <exception cref="SessionException">It is not kept.</exception>
    public byte[] Png(int id)
    {
        (_, LinearPicture picture, Tone tone) = Find(id);
        return ImageFile.Encode(".png", picture, tone.Writing);
    }

    /// <summary>Compares two pictures.</summary>
    /// <param name="image">The number of the one that is judged.</param>
    /// <param name="reference">The number of the other.</param>
    /// <exception cref="SessionException">One is not kept, or they differ in size.</exception>
    public PictureComparison Compare(int image, int reference)
    {
        (LinearPicture a, LinearPicture b) = (Find(image).Picture, Find(reference).Picture);
        if ((a.Width, a.Height) != (b.Width, b.Height))
        {
            throw new SessionException($"The pictures differ in size: {a.Width}×{a.Height} and {b.Width}×{b.Height} pixels.");
        }

        if (_lock.Read(() => _compared) is { } known && (known.Image, known.Reference) == (image, reference))
        {
            return known.Found;
        }

        ImageComparison light = ImageComparison.Compare(a, b);
        FlipError flip = FlipError.Compare(ImageFile.Decode(Png(image)), ImageFile.Decode(Png(reference)));
        PictureComparison found = new(light.Rmse, light.LargestDifference, light.LargestX, light.LargestY, flip.Mean) { Errors = flip };
        _lock.Read(() => _compared = (image, reference, found));
        return found;
    }

    /// <summary>A picture of how two pictures differ, as a PNG.</summary>
    /// <param name="image">The number of the one that is judged.</param>
    /// <param name="reference">The number of the other.</param>
    /// <param name="map">What is shown.</param>
    /// <exception cref="SessionException">One is not kept, or they differ in size.</exception>
    public byte[] Png(int image, int reference, ComparisonMap map)
    {
        PictureComparison found = Compare(image, reference);
        float scale = found.LargestDifference > 0 ? (float)(1 / found.LargestDifference) : 1;
        return ImageFile.Encode(
            ".png", map == ComparisonMap.Flip ? found.Errors! : new DifferenceRows(Find(image).Picture, Find(reference).Picture, scale), Tone.Plain.Writing);
    }

    private (Snapshot Snapshot, LinearPicture Picture, Tone Tone) Find(int id)
    {
        lock (_lock)
        {
            int at = _kept.FindIndex(k => k.Snapshot.Id == id);
            return at >= 0 ? _kept[at] : throw new SessionException($"Snapshot {id} is not kept.", SessionFault.Missing);
        }
    }
}

/// <summary>An earlier picture, kept for comparison.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Name">Its name.</param>
/// <param name="Samples">Samples in each pixel.</param>
/// <param name="Time">The time of day when it was kept.</param>
public sealed record Snapshot(int Id, string Name, int Samples, string Time)
{
    /// <summary>What it is, in a few words.</summary>
    public string Label => SessionTexts.Of("compare.label", Name, Samples, Time);

    /// <summary>The number of the document that it shows.</summary>
    public int Document { get; init; }
}
