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
            snapshot = new(++_lastId, string.Create(CultureInfo.InvariantCulture, $"{samples} samples, {time.GetLocalNow():HH:mm:ss}")) { Document = document };
            _kept.Add((snapshot, picture, view.Tone));
            if (_kept.Count > Most)
            {
                _kept.RemoveAt(0);
            }
        }

        Changed?.Invoke();
        return snapshot;
    }

    /// <summary>A picture as a PNG.</summary>
    /// <exception cref="SessionException">It is not kept.</exception>
    public byte[] Png(int id)
    {
        (LinearPicture? picture, Tone tone) = Find(id);
        return ImageFile.Encode(".png", picture, tone.Writing);
    }

    private (LinearPicture Picture, Tone Tone) Find(int id)
    {
        lock (_lock)
        {
            return _kept.Find(k => k.Snapshot.Id == id) is { Picture: { } picture } found
                ? (picture, found.Tone)
                : throw new SessionException($"Snapshot {id} is not kept.", SessionFault.Missing);
        }
    }
}

/// <summary>An earlier picture, kept for comparison.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Label">A description in a few words.</param>
public sealed record Snapshot(int Id, string Label)
{
    /// <summary>The number of the document that it shows.</summary>
    public int Document { get; init; }
}
