using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Moves of the camera: seen at once, and written to the text when a gesture ends.</summary>
/// <param name="dispatcher">Carries them to the session.</param>
internal sealed class CameraDrive(SessionDispatcher dispatcher)
{
    private static readonly TimeSpan BurstPause = TimeSpan.FromMilliseconds(350);
    private readonly Dictionary<CameraMoveKind, (string Gesture, int Count)> _bursts = [];
    private Latest<IReadOnlyList<CameraMove>>? _latest;

    private Latest<IReadOnlyList<CameraMove>> Moves => _latest ??= new(Send, Merge);

    /// <summary>A part of a gesture.</summary>
    public void Move(CameraMoveKind kind, string gesture, double dx, double dy, double dz = 0) =>
        Moves.Push([new(kind, (float)dx, (float)dy, (float)dz, gesture)]);

    /// <summary>A gesture ends.</summary>
    public void End(CameraMoveKind kind, string gesture) => Moves.Push([new(kind, Gesture: gesture, End: true)]);

    /// <summary>A move that has no natural end, such as a turn of the wheel: it ends when no other of its kind follows soon.</summary>
    public void Burst(CameraMoveKind kind, double dx, double dy, double dz = 0)
    {
        (string Gesture, int Count) burst = _bursts.TryGetValue(kind, out (string Gesture, int Count) before) ? (before.Gesture, before.Count + 1) : (Gesture.New(), 0);
        _bursts[kind] = burst;
        Move(kind, burst.Gesture, dx, dy, dz);
        _ = EndBurst(kind, burst);
    }

    /// <summary>To the scene's own camera.</summary>
    public void Home() => Moves.Push([new(CameraMoveKind.Home, Gesture: Gesture.New(), End: true)]);

    private async Task EndBurst(CameraMoveKind kind, (string Gesture, int Count) burst)
    {
        await Task.Delay(BurstPause);
        if (_bursts.TryGetValue(kind, out (string Gesture, int Count) now) && now == burst)
        {
            _bursts.Remove(kind);
            End(kind, burst.Gesture);
        }
    }

    private Task Send(IReadOnlyList<CameraMove> moves) => dispatcher.Attempt(() => dispatcher.Ask(session =>
    {
        foreach (CameraMove move in moves)
        {
            session.Camera.Move(move);
        }

        return true;
    }));

    // Moves of one kind and gesture become one; others follow each other.
    private static List<CameraMove> Merge(IReadOnlyList<CameraMove> older, IReadOnlyList<CameraMove> newer)
    {
        List<CameraMove> all = [.. older];
        foreach (CameraMove move in newer)
        {
            if (all[^1] is { End: false } last && last.Kind == move.Kind && last.Gesture == move.Gesture)
            {
                all[^1] = last with { Dx = last.Dx + move.Dx, Dy = last.Dy + move.Dy, Dz = last.Dz + move.Dz, End = move.End };
            }
            else
            {
                all.Add(move);
            }
        }

        return all;
    }
}
