using System.ComponentModel;
using System.Runtime.CompilerServices;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Tells whoever shows it when its properties change.</summary>
internal abstract class Observable : INotifyPropertyChanged
{
    private int _telling;

    /// <inheritdoc/>
    public event PropertyChangedEventHandler? PropertyChanged;

    /// <summary>Whether somebody is being told of a change: what they set meanwhile is what they make of it, not what the user wants.</summary>
    protected bool IsTelling => _telling > 0;

    /// <summary>Sets a field; returns whether it has changed.</summary>
    protected bool Set<T>(ref T field, T value, [CallerMemberName] string name = "")
    {
        if (EqualityComparer<T>.Default.Equals(field, value))
        {
            return false;
        }

        field = value;
        Tell(name);
        return true;
    }

    /// <summary>Tells that a property has changed; without a name, that all may have.</summary>
    protected void Tell([CallerMemberName] string name = "")
    {
        _telling++;
        PropertyChanged?.Invoke(this, new(name));
        _telling--;
    }
}
