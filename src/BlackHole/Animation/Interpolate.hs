-- | Values between keys: how a number, or several at once, goes from one given
-- time to the next.
module BlackHole.Animation.Interpolate
  ( Interpolation (..),
    interpolationName,
    Keys,
    KeysProblem (..),
    renderKeysProblem,
    makeKeys,
    valueAt,
    easedFraction,
    unwrapDegrees,
  )
where

import Data.List (zipWith4)
import Data.List.NonEmpty (NonEmpty (..))
import qualified Data.List.NonEmpty as NonEmpty

-- | The way from a key to the next.
data Interpolation
  = -- | Stays at the former key's value until the next key's time.
    Held
  | -- | Straight, at constant speed.
    Linear
  | -- | Straight, from rest to rest: the fraction @s@ of the time becomes
    -- @3s² − 2s³@ of the way. Stops at every key.
    Eased
  | -- | A Catmull-Rom curve: a cubic between any two keys whose slope at an
    -- inner key is that of the parabola through it and its neighbours, so that
    -- keys at unequal times are passed smoothly. At the first and last key the
    -- slope is the chord's, and the slope at their neighbours is at most five
    -- times that chord's: the least limit with which the curve does not swing
    -- back beyond an end, and rests between two equal keys there. Between inner
    -- keys it may swing beyond their values, as all such curves do.
    Smooth
  deriving (Eq, Show, Enum, Bounded)

-- | The name in a scene file.
interpolationName :: Interpolation -> String
interpolationName kind = case kind of
  Held -> "held"
  Linear -> "linear"
  Eased -> "eased"
  Smooth -> "smooth"

-- | At least one key: times, strictly growing, with values of one dimension.
newtype Keys = Keys (NonEmpty (Double, [Double]))
  deriving (Eq, Show)

-- | What is wrong with a list of keys.
data KeysProblem
  = -- | There is none.
    NoKeys
  | -- | A time or value is not a finite number; the key's index from 0.
    NotFinite !Int
  | -- | A key's time is not later than that of the key before it.
    NotLater !Int
  | -- | A key has another number of values than the first one.
    OtherDimension !Int
  deriving (Eq, Show)

-- | The problem as one clause.
renderKeysProblem :: KeysProblem -> String
renderKeysProblem problem = case problem of
  NoKeys -> "there are no keys"
  NotFinite i -> "key " ++ show (i + 1) ++ " holds a number that is not finite"
  NotLater i -> "key " ++ show (i + 1) ++ " is not later than the one before it"
  OtherDimension i -> "key " ++ show (i + 1) ++ " has another number of values than the first"

-- | Check a list of times and values.
makeKeys :: [(Double, [Double])] -> Either KeysProblem Keys
makeKeys [] = Left NoKeys
makeKeys (first : rest) = case problems of
  problem : _ -> Left problem
  [] -> Right (Keys (first :| rest))
  where
    keys = zip [0 ..] (first : rest)
    problems =
      [NotFinite i | (i, (t, v)) <- keys, any notFinite (t : v)]
        ++ [ NotLater i
             | ((i, (t, _)), (before, _)) <- zip (drop 1 keys) (first : rest),
               t <= before
           ]
        ++ [OtherDimension i | (i, (_, v)) <- keys, length v /= length (snd first)]
    notFinite x = isNaN x || isInfinite x

-- | The values at a time. Before the first key they are the first key's, after
-- the last the last's; at a key they are exactly the key's own. Linear in the
-- number of keys.
valueAt :: Interpolation -> Keys -> Double -> [Double]
valueAt kind (Keys keys@((_, initial) :| rest)) t = go (zip (NonEmpty.toList keys) slopes) initial
  where
    go (((ta, a), ma) : later@(((tb, b), mb) : _)) _
      | t <= ta = a
      | t < tb = between (t - ta) (tb - ta) a b ma mb
      | otherwise = go later b
    go _ lastly = lastly
    slopes
      | kind == Smooth = smoothSlopes keys
      | otherwise = [] : map (const []) rest
    between past h a b ma mb = case kind of
      Held -> a
      Linear -> straight s
      Eased -> straight (easedFraction s)
      Smooth -> zipWith4 (hermite h s) a b ma mb
      where
        s = past / h
        straight part = zipWith (\x y -> x + part * (y - x)) a b

-- | The cubic from @x@ to @y@ with the given slopes over a time @h@.
hermite :: Double -> Double -> Double -> Double -> Double -> Double -> Double
hermite h s x y mx my =
  x + s * (h * mx + s * ((3 * (y - x) - h * (2 * mx + my)) + s * (h * (mx + my) - 2 * (y - x))))

-- | The slopes of the smooth curve, one for each key.
smoothSlopes :: NonEmpty (Double, [Double]) -> [[Double]]
smoothSlopes (first :| rest) = case (chords, reverse chords) of
  ((_, opening) : _, (_, closing) : _) ->
    [opening] ++ limited opening closing (zipWith parabola chords (drop 1 chords)) ++ [closing]
  _ -> [map (const 0) (snd first)]
  where
    chords = zipWith chord (first : rest) rest
    chord (ta, a) (tb, b) = (tb - ta, zipWith (\x y -> (y - x) / (tb - ta)) a b)
    parabola (h1, d1) (h2, d2) = zipWith (\p q -> (h2 * p + h1 * q) / (h1 + h2)) d1 d2
    -- With the chord's slope d at the end and m beside it, the cubic is
    -- x + hs(d + (d − m)s(1 − s)), and s(1 − s) is at most 1/4.
    limited opening closing = onLast (zipWith limit closing) . onFirst (zipWith limit opening)
    limit d m = max (-5 * abs d) (min (5 * abs d) m)
    onFirst f (x : xs) = f x : xs
    onFirst _ [] = []
    onLast f = reverse . onFirst f . reverse

-- | From rest to rest: @3s² − 2s³@, 0 up to 0 and 1 from 1 on.
easedFraction :: Double -> Double
easedFraction s
  | s <= 0 = 0
  | s >= 1 = 1
  | otherwise = s * s * (3 - 2 * s)

-- | Add whole turns to each angle (degrees) so that it lies at most half a turn
-- from the one before it: from 350 to 10 the way is then 20 degrees, not −340.
unwrapDegrees :: [Double] -> [Double]
unwrapDegrees [] = []
unwrapDegrees (first : rest) = scanl near first rest
  where
    near before angle = angle + 360 * fromIntegral (round ((before - angle) / 360) :: Integer)
